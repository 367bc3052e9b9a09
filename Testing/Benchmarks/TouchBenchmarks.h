#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Ticks of tools that slide over structures: spherical harmonics compared with VTK's closest
/// points on 8,000 triangles, 8,000 to 128,000 facets with spherical harmonics, the two tools of
/// fields, large tools with small ones, and scenes of many structures with one.
std::vector<PairedBenchmark> TouchBenchmarks();
} // namespace palpate::bench
