#pragma once

#include <Eigen/Core>

namespace palpate
{
/// A point or a vector; the name of each variable says in which frame and unit.
using Vector3 = Eigen::Vector3d;
} // namespace palpate
