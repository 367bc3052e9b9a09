#include "LengthText.h"

#include "DecimalText.h"

namespace palpate
{
const char* SymbolOf(LengthUnit unit)
{
  return unit == LengthUnit::Centimeter ? "cm" : "mm";
}

double LengthIn(LengthUnit unit, double millimeters)
{
  constexpr double MillimetersPerCentimeter = 10.0;
  return unit == LengthUnit::Centimeter ? millimeters / MillimetersPerCentimeter : millimeters;
}

int DecimalsIn(LengthUnit unit, int decimals)
{
  return unit == LengthUnit::Centimeter ? decimals + 1 : decimals;
}

std::string LengthText(LengthUnit unit, double millimeters, int decimals)
{
  return FixedText(LengthIn(unit, millimeters), DecimalsIn(unit, decimals)) + " " + SymbolOf(unit);
}
} // namespace palpate
