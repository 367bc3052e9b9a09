#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// From a mask's file to a measured model, against the stock way to a mere surface.
std::vector<PairedBenchmark> PipelineBenchmarks();
} // namespace palpate::bench
