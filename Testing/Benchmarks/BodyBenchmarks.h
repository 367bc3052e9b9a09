#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Signed distances from a mask's boundary, as comparisons of bodies need them, against VTK's.
std::vector<PairedBenchmark> BodyBenchmarks();
} // namespace palpate::bench
