#pragma once

#include "DisplayServer.h"
#include "PairedBenchmark.h"

#include <memory>
#include <vector>

namespace palpate::bench
{
/// Whole frames of one view of one volume, by vtkSubVoxelVolumeMapper and by VTK's own ways to show
/// an iso-surface. None where there is no X server and none can be started.
std::vector<PairedBenchmark> RenderBenchmarks(const std::shared_ptr<DisplayServer>& display);
} // namespace palpate::bench
