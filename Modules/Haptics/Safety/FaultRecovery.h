#pragma once

#include "SafetyReport.h"

#include <cstdint>

namespace palpate
{
/// Decides which faults end by themselves, and when.
///
/// With motors none does: a force that comes back unannounced may hurt, so a person has to switch
/// it on again. Without motors nothing can push on a person; a fault of timing then ends after Wait
/// without any fault. Depends on the ticks alone, so that a recorded session replays.
class FaultRecovery
{
public:
  /// ns; recordings depend on it.
  static constexpr std::int64_t Wait = 250'000'000;

  explicit FaultRecovery(bool hasMotors) noexcept : HasMotors(hasMotors) {}

  /// Whether this fault ends by itself.
  bool EndsByItself(SafetyFault fault) const noexcept;
  /// A fault occurred, or ticks paused: the wait starts again.
  void Restart() noexcept { this->IsWaiting = false; }
  /// Once per tick without a fault, which started at `time` (ns): whether the wait is over.
  bool IsOver(std::int64_t time) noexcept;

private:
  bool HasMotors;
  bool IsWaiting = false;
  std::int64_t Since = 0; // ns, of the first good tick
};
} // namespace palpate
