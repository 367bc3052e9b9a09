#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Radius, gradient and Hessian of a model, in every way that a caller may ask, in double and
/// float, by both formulations and with both instruction sets, against GSL, the standard library,
/// libsharp and our own slower ways. 4,002 points; in "chained" each direction waits for the last
/// result.
std::vector<PairedBenchmark> EvaluationBenchmarks();
} // namespace palpate::bench
