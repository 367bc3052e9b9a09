#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Ticks of tools that slide over structures: spherical harmonics against VTK's closest points on
/// 8,000 triangles, facets against spherical harmonics, and the two tools of fields.
std::vector<PairedBenchmark> TouchBenchmarks();
} // namespace palpate::bench
