#pragma once

#include "Vector3.h"

#include <vector>

namespace palpate
{
/// The largest distance (mm) between two of many points; 0 of none. Exact unless two pairs in
/// different directions are as far to a part in 300; then one of them is found. From the widest of
/// 321 directions, whose farthest points lead to points that are each other's farthest.
double DiameterOf(const std::vector<Vector3>& points);
} // namespace palpate
