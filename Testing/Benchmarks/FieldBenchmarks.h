#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Inside tests and first hits in a skull-like volume, compared with interpolation by VTK and ITK.
std::vector<PairedBenchmark> FieldBenchmarks();
} // namespace palpate::bench
