#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// Closest point and curvature of a model of degree 12, compared with VTK's on its mesh of 8,000
/// triangles.
std::vector<PairedBenchmark> NearestBenchmarks();
} // namespace palpate::bench
