#pragma once

// Geometry and not only Core: without it a cross product compiles and is missing at link time.
#include <Eigen/Geometry>

namespace palpate
{
/// A point or a vector; the name of each variable says in which frame and unit.
using Vector3 = Eigen::Vector3d;
/// A 3 x 3 matrix; the same holds.
using Matrix3 = Eigen::Matrix3d;
} // namespace palpate
