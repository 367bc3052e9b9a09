#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Frames of four linked views of a brain at 1280 x 800, while the crosshair moves. Need a
/// display.
std::vector<PairedBenchmark> ViewBenchmarks();
} // namespace palpate::bench
