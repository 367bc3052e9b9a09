#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Certified bounds of a model's radius over a cone, compared with the extremes of samples in it.
std::vector<PairedBenchmark> BoundsBenchmarks();
} // namespace palpate::bench
