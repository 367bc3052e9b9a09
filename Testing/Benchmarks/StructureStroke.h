#pragma once

#include "ServoStroke.h"

namespace palpate::bench
{
constexpr std::size_t StructureTicks = 4000;

/// Strokes one of many structures that can all be touched: an organ of degree 12, 1.5 mm deep at 50
/// mm/s. The others, balls of 20 facets 60 mm apart, are round it. Throws std::runtime_error where
/// the scene cannot be made.
std::unique_ptr<ServoStroke> StructureStroke(int count);
} // namespace palpate::bench
