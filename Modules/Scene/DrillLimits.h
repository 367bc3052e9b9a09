#pragma once

namespace palpate
{
/// What files may say of drilling at most.
namespace DrillLimits
{
inline constexpr double Wear = 100.0;      ///< mm for each N of push and m of rubbing
inline constexpr double Drag = 10.0;       ///< s/mm
inline constexpr double Alarm = 1e3;       ///< mm
inline constexpr double Turns = 1e4;       ///< a second
inline constexpr double Vibration = 500.0; ///< Hz
} // namespace DrillLimits
} // namespace palpate
