#pragma once

namespace palpate
{
/// State of a device. Forces are rendered in Ready only.
enum class DeviceState
{
  Closed,  ///< not in use; from here it can be opened
  Opening, ///< searching, or loading firmware
  Homing,  ///< returns samples whose positions are not valid yet
  Ready,   ///< returns positions and accepts forces
  Error    ///< failed; must be closed and opened again
};

/// "closed", "opening", "homing", "ready", "error".
inline const char* NameOf(DeviceState state) noexcept
{
  constexpr const char* Names[] = {"closed", "opening", "homing", "ready", "error"};
  return Names[static_cast<int>(state)];
}
} // namespace palpate
