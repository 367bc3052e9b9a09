#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Radius and gradient in every way that a caller may ask, and more and less than that, against
/// public libraries: GSL, libsharp and the standard library.
std::vector<PairedBenchmark> EvaluationBenchmarks();
} // namespace palpate::bench
