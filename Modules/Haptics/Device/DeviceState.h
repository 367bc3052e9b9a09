#pragma once

namespace palpate
{
/// The life of a device. Forces are given in Ready only.
enum class DeviceState
{
  Closed,  ///< not in use; from here it can be opened
  Opening, ///< being found, or its firmware loaded
  Homing,  ///< gives samples whose positions mean nothing yet
  Ready,   ///< gives positions and takes forces
  Error    ///< failed; it has to be closed and opened again
};

/// "closed", "opening", "homing", "ready", "error".
const char* NameOf(DeviceState state) noexcept;
} // namespace palpate
