#pragma once

// Geometry and not only Core: without it a cross product compiles but does not link.
#include <Eigen/Geometry>

namespace palpate
{
/// A point or a vector; the variable's name states frame and unit.
using Vector3 = Eigen::Vector3d;
/// A 3 x 3 matrix; the variable's name states frame and unit.
using Matrix3 = Eigen::Matrix3d;
} // namespace palpate
