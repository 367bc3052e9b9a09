#pragma once

#include <atomic>

namespace palpate
{
/// While it is ordered, every ServoThread of the process switches its forces off in every tick
/// (SafetyFault::SwitchedOff), whatever other threads do or hang in. Nothing else reads it: what is
/// computed or replayed stays as it is.
///
/// It is global, since a signal handler reaches nothing else. For any thread and for signal
/// handlers.
class EmergencyStop
{
public:
  static void Order() noexcept { Wanted.store(true, std::memory_order_relaxed); }
  /// Forces that are off stay so until Servo::Rearm.
  static void Forget() noexcept { Wanted.store(false, std::memory_order_relaxed); }
  static bool IsOrdered() noexcept { return Wanted.load(std::memory_order_relaxed); }

private:
  static std::atomic<bool> Wanted;
  static_assert(std::atomic<bool>::is_always_lock_free);
};
} // namespace palpate
