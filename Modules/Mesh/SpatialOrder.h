#pragma once

#include "Vector3.h"

#include <vector>

namespace palpate
{
/// The numbers of finite points along a curve that fills their box, so that points which follow
/// each other are close, as searches want them (Morton, "A computer oriented geodetic data base and
/// a new technique in file sequencing", IBM, 1966).
std::vector<int> SpatialOrder(const std::vector<Vector3>& points);
} // namespace palpate
