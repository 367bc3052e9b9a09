#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Whole frames of one view of one volume, by vtkSubVoxelVolumeMapper and by VTK's own ways to show
/// an iso-surface. Need a display.
std::vector<PairedBenchmark> RenderBenchmarks();
} // namespace palpate::bench
