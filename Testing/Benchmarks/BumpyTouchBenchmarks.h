#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Ticks of spheres that do not fit into every hollow of a body, next to the same by a search of
/// the whole surface a step; and ticks in float next to those in double.
std::vector<PairedBenchmark> BumpyTouchBenchmarks();
} // namespace palpate::bench
