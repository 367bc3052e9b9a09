#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Inside tests and first hits in a skull-like volume, against what VTK and ITK interpolate with.
std::vector<PairedBenchmark> FieldBenchmarks();
} // namespace palpate::bench
