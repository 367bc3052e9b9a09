#pragma once

#include "TouchState.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace palpate
{
/// What the ticks of a session say of one stop of all force: how strong the last force before it
/// was, and how many ticks passed until the device got 0 N.
struct StopProof
{
  static constexpr int MostTicks = 2;
  static constexpr double LeastForce = 0.1; ///< N; less proves nothing

  double ForceBefore = 0.0; ///< N, in the last tick that began before the stop
  int Ticks = 0;            ///< that began after it, up to the first with 0 N; 0: none had
  int TicksAfter = 0;       ///< later ones
  bool StaysOff = false;    ///< all of those have 0 N, too
  std::int64_t Delay = 0;   ///< ns from the stop to the start of the first tick with 0 N

  bool HadForce() const noexcept { return this->ForceBefore >= LeastForce; }
  /// A force acted, and ended within MostTicks, for good. False also if no tick after it tells.
  bool IsPassed() const noexcept
  {
    return this->HadForce() && this->Ticks > 0 && this->Ticks <= MostTicks && this->StaysOff &&
           this->TicksAfter > 0;
  }

  /// Of a stop at `stopped` (ns of the servo's clock). A force and a torque count as 0 only if the
  /// device has taken them, or is gone.
  static StopProof Of(const std::vector<TouchState>& ticks, std::int64_t stopped) noexcept;
  /// When the first fault, or the clutch, ended a force that acted: the start of its tick (ns);
  /// none if nothing did.
  static std::optional<std::int64_t> FindStop(const std::vector<TouchState>& ticks) noexcept;
};
} // namespace palpate
