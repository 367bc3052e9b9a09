#pragma once

#include <string>

namespace palpate
{
/// In which lengths are shown to people. Everything is computed and written in mm.
enum class LengthUnit
{
  Millimeter,
  Centimeter
};

/// "mm", "cm".
const char* SymbolOf(LengthUnit unit);
/// A length or coordinate (mm) in the unit.
double LengthIn(LengthUnit unit, double millimeters);
/// The decimals with which the unit resolves as much as `decimals` of a mm do.
int DecimalsIn(LengthUnit unit, int decimals);
/// "12.3 mm", or "1.23 cm"; a dash for what is not finite.
std::string LengthText(LengthUnit unit, double millimeters, int decimals);
} // namespace palpate
