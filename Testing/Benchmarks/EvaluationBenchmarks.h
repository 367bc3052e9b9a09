#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Radius and gradient of a model of degree 12, in every way that a caller may ask, against the
/// scalar recurrence.
std::vector<PairedBenchmark> EvaluationBenchmarks();
} // namespace palpate::bench
