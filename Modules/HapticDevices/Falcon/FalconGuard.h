#pragma once

#include <atomic>
#include <string>
#include <sys/types.h>

namespace palpate
{
/// A small process next to this one that tells a Falcon's board 0 N where this process cannot: when
/// it ends without a word (a crash, SIGKILL), and when the device left the bus and comes back while
/// the board kept its supply. It has its own session, so no signal of a terminal reaches it, and
/// holds nothing of the device until then. The program is palpate-falcon-guard.
///
/// Start, Dismiss, destruction: the owner's thread. Call: any.
class FalconGuard
{
public:
  FalconGuard() = default;
  FalconGuard(const FalconGuard&) = delete;
  FalconGuard& operator=(const FalconGuard&) = delete;
  /// Dismisses the guard, unless it was called: then it finishes by itself.
  ~FalconGuard();

  /// Guards the Falcon at this bus path ("1-2.3"). Returns false if the program is not found; then
  /// there is no guard.
  bool Start(const std::string& busPath);
  bool IsRunning() const noexcept { return this->Socket >= 0; }
  /// Requests a stop as soon as the device can be claimed: it left the bus, or was closed before it
  /// took 0 N. Neither waits nor allocates.
  void Call() noexcept;
  /// Whether Call was the last request to the guard.
  bool WasCalled() const noexcept { return this->HasCalled.load(); }
  /// Ends the guard. Returns within a second, once it no longer holds the device.
  void Dismiss() noexcept;

  /// Requests to the process; the end of its input means that this process is gone.
  static constexpr char Stop = 's';
  static constexpr char Quit = 'q';

private:
  void Say(char word) const noexcept;

  int Socket = -1;
  pid_t Process = -1;
  std::atomic<bool> HasCalled{false};
};
} // namespace palpate
