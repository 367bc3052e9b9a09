#pragma once

#include "PalpateTradeModule.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace palpate
{
/// The places in `points` (cost, error) that no other dominates, by rising cost: none is at most as
/// costly and at most as wrong, and better in one of both. Points that are not finite are none.
PALPATETRADE_EXPORT std::vector<std::size_t>
ParetoFront(const std::vector<std::pair<double, double>>& points);
} // namespace palpate
