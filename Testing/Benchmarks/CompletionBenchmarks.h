#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// A surface completed from touches after one of them changed, with its standard deviations along
/// 642 directions, against a refit from nothing.
std::vector<PairedBenchmark> CompletionBenchmarks();
} // namespace palpate::bench
