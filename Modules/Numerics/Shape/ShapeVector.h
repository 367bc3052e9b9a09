#pragma once

#include "SurfaceModel.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// A model's coefficients (mm) as one vector: of a parametric surface x, then y, then z. Allocates.
Eigen::VectorXd VectorOf(const SurfaceModel& shape);

/// RMS over the sphere of the radii or points (mm) with these coefficients, of a shape or of the
/// difference of two: as the harmonics are orthonormal, their length over sqrt(4 pi).
double RmsOverSphere(const Eigen::Ref<const Eigen::VectorXd>& coefficients);

/// The model of a kind and degree with these coefficients, about the origin. `values` as from
/// VectorOf(like). Allocates.
SurfaceModel ShapeFrom(const Eigen::Ref<const Eigen::VectorXd>& values, const SurfaceModel& like);

/// The mean of shapes of one kind and degree, about the origin; at least one. Allocates.
SurfaceModel MeanShape(const std::vector<SurfaceModel>& shapes);

/// The model with zeros for further degrees, or without those above. Allocates.
SurfaceModel WithDegree(const SurfaceModel& shape, int degree);
} // namespace palpate
