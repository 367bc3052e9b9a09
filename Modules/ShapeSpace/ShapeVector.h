#pragma once

#include "OrganModel.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// A model's coefficients (mm) as one vector: of a surface model x, then y, then z. Allocates.
Eigen::VectorXd VectorOf(const OrganModel& shape);

/// RMS over the sphere of the radii or points (mm) with these coefficients, of a shape or of the
/// difference of two: as the harmonics are orthonormal, their length over sqrt(4 pi).
double RmsOverSphere(const Eigen::Ref<const Eigen::VectorXd>& coefficients);

/// The model of a kind and degree with these coefficients, about the origin. `values` as from
/// VectorOf(like). Allocates.
OrganModel ShapeFrom(const Eigen::Ref<const Eigen::VectorXd>& values, const OrganModel& like);

/// The mean of shapes of one kind and degree, about the origin; at least one. Allocates.
OrganModel MeanShape(const std::vector<OrganModel>& shapes);

/// The model with zeros for further degrees, or without those above. Allocates.
OrganModel WithDegree(const OrganModel& shape, int degree);
} // namespace palpate
