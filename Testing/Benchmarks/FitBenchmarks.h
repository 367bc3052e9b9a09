#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Fits of 4,002 samples at degree 12, in every way that a caller may ask, against stock methods of
/// Eigen on the same samples. The alternatives are given the matrix of harmonics, which ours does
/// not need.
std::vector<PairedBenchmark> FitBenchmarks();
} // namespace palpate::bench
