#pragma once

#include "PairedBenchmark.h"

#include <vector>

namespace palpate::bench
{
/// A capsule that strokes a radial model, against as many spheres with trackers of their own; and
/// one ball against one sphere, which give the same places.
std::vector<PairedBenchmark> RigidToolBenchmarks();
} // namespace palpate::bench
