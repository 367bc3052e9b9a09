#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// From a mask's file to a measured model, compared with the stock pipeline to a surface only.
std::vector<PairedBenchmark> PipelineBenchmarks();
} // namespace palpate::bench
