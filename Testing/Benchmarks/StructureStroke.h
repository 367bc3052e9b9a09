#pragma once

#include "ServoStroke.h"

namespace palpate::bench
{
constexpr std::size_t StructureTicks = 4000;

/// Strokes one of many touchable structures: an organ of degree 12, 1.5 mm deep at 50 mm/s. The
/// others, spheres of 20 facets 60 mm apart, surround it. Throws std::runtime_error if the scene
/// cannot be made.
std::unique_ptr<ServoStroke> StructureStroke(int count);
} // namespace palpate::bench
