#pragma once

#include <atomic>

namespace palpate
{
/// While ordered, every ServoThread of the process switches its forces off in every tick
/// (SafetyFault::SwitchedOff), even if other threads hang. Nothing else reads it: computation and
/// replay are unaffected.
///
/// Global, since a signal handler can reach nothing else. For any thread and for signal handlers.
class EmergencyStop
{
public:
  static void Order() noexcept { Wanted.store(true, std::memory_order_relaxed); }
  /// Forces remain off until Servo::Rearm.
  static void Forget() noexcept { Wanted.store(false, std::memory_order_relaxed); }
  static bool IsOrdered() noexcept { return Wanted.load(std::memory_order_relaxed); }

private:
  static std::atomic<bool> Wanted;
  static_assert(std::atomic<bool>::is_always_lock_free);
};
} // namespace palpate
