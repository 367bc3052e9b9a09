#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// The least-squares fit against a stock factorisation of the same matrix.
std::vector<PairedBenchmark> FitBenchmarks();
} // namespace palpate::bench
