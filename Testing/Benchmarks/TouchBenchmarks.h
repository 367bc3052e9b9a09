#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Ticks of tools that slide over structures: spherical harmonics against VTK's closest points on
/// 8,000 triangles, 8,000 to 128,000 facets against spherical harmonics, the two tools of fields,
/// large tools against small ones, and scenes of many structures against one.
std::vector<PairedBenchmark> TouchBenchmarks();
} // namespace palpate::bench
