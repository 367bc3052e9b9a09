#pragma once

#include <atomic>
#include <chrono>
#include <libusb.h>
#include <poll.h>
#include <vector>

namespace palpate
{
/// Waits until a libusb context has something to do or another thread says Wake, which neither
/// locks nor allocates. For one waiting thread.
class LibusbPoll
{
public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// Keeps the context, which must outlive it and have no other such object.
  explicit LibusbPoll(libusb_context* context);
  ~LibusbPoll();
  LibusbPoll(const LibusbPoll&) = delete;
  LibusbPoll& operator=(const LibusbPoll&) = delete;

  /// False where the system gave no descriptor.
  bool IsUsable() const noexcept { return this->WakeDescriptor >= 0; }
  /// Ends a wait, or the next. From any thread.
  void Wake() noexcept;
  /// Until then at most. `withDevice` is false where the device is gone, whose descriptor is ready
  /// for ever.
  void Wait(TimePoint until, bool withDevice) noexcept;

private:
  void Fetch();

  libusb_context* Context;
  int WakeDescriptor;
  std::vector<pollfd> Set; // the first is to wake
  std::atomic<bool> IsOld{true};
};
} // namespace palpate
