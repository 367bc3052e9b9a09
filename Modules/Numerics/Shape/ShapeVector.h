#pragma once

#include "SurfaceModel.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// A model's coefficients (mm) as one vector: of a parametric surface x, then y, then z. As the
/// harmonics are orthonormal, the distance of two vectors over sqrt(4 pi) is the RMS distance over
/// the sphere of radii or points. Allocates.
Eigen::VectorXd VectorOf(const SurfaceModel& shape);

/// The model of a kind and degree with these coefficients, about the origin. `values` as from
/// VectorOf(like). Allocates.
SurfaceModel ShapeFrom(const Eigen::Ref<const Eigen::VectorXd>& values, const SurfaceModel& like);

/// The mean of shapes of one kind and degree, about the origin; at least one. Allocates.
SurfaceModel MeanShape(const std::vector<SurfaceModel>& shapes);

/// The model with zeros for further degrees, or without those above. Allocates.
SurfaceModel WithDegree(const SurfaceModel& shape, int degree);
} // namespace palpate
