#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// A tick of a servo that drills, with the cuts and the versions that follow from it, beside
/// building the field anew for each cut.
std::vector<PairedBenchmark> DrillBenchmarks();
} // namespace palpate::bench
