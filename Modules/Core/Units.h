#pragma once

namespace palpate
{
///@{ Factors between units.
constexpr double Pi = 3.14159265358979323846;
constexpr double DegreesPerRadian = 180.0 / Pi;
constexpr double SecondsPerNanosecond = 1e-9;
constexpr double MicrosecondsPerNanosecond = 1e-3;
constexpr double CubicMillimetersPerMilliliter = 1000.0;
constexpr double MegapascalsPerKilopascal = 1e-3; // a megapascal is 1 N/mm^2
///@}
} // namespace palpate
