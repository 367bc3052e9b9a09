#pragma once

#include "Vector3.h"

namespace palpate
{
/// A direction from which all sides of a spherical polygon are seen counter-clockwise: the mean of
/// the boundary of its kernel, the cone { u : u . (p_i x p_i+1) > 0 }. `polygon` has `count` (3 to
/// 12) unit vectors counter-clockwise and is star-shaped as seen from its first corner, so that its
/// kernel is open and not empty. Zero if the kernel is thinner than rounding.
Vector3 KernelDirection(const Vector3* polygon, int count);
} // namespace palpate
