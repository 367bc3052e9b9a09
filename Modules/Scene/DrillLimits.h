#pragma once

namespace palpate
{
/// Largest values of drilling parameters in files.
namespace DrillLimits
{
inline constexpr double Wear = 100.0;      ///< mm per N of push and m of sliding
inline constexpr double Drag = 10.0;       ///< s/mm
inline constexpr double Alarm = 1e3;       ///< mm
inline constexpr double Turns = 1e4;       ///< 1/s
inline constexpr double Vibration = 500.0; ///< Hz
} // namespace DrillLimits
} // namespace palpate
