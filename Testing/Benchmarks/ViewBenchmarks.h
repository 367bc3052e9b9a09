#pragma once

#include "DisplayServer.h"
#include "PairedBenchmark.h"

#include <memory>
#include <vector>

namespace palpate::bench
{
/// Frames of four linked views of a brain at 1280 x 800, while the crosshair moves. None without a
/// display.
std::vector<PairedBenchmark> ViewBenchmarks(const std::shared_ptr<DisplayServer>& display);
} // namespace palpate::bench
