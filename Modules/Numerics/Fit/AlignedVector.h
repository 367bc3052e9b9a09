#pragma once

#include "PolynomialTable.h"

#include <vector>

namespace palpate
{
/// Doubles on cache lines, as the kernels want them.
using AlignedVector = std::vector<double, CacheLineAllocator<double>>;
} // namespace palpate
