#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// A surface model's point and derivatives against three separate series with the same
/// instruction set, and against GSL.
std::vector<PairedBenchmark> SurfaceBenchmarks();
} // namespace palpate::bench
