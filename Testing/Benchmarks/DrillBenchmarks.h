#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// A tick of a servo that drills, with the resulting cuts and versions, compared with rebuilding
/// the field for each cut.
std::vector<PairedBenchmark> DrillBenchmarks();
} // namespace palpate::bench
