#pragma once

#include "PalpateTradeModule.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace palpate
{
/// Indices of the points (cost, error) on the Pareto front, sorted by cost: no other point is at
/// least as good in both and better in one. Points that are not finite are skipped.
PALPATETRADE_EXPORT std::vector<std::size_t>
ParetoFront(const std::vector<std::pair<double, double>>& points);
} // namespace palpate
