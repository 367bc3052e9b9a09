#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Ticks of balls that do not fit into every hollow of a body, beside the same by a search of the
/// whole surface a step; and ticks in float beside those in double.
std::vector<PairedBenchmark> BumpyTouchBenchmarks();
} // namespace palpate::bench
