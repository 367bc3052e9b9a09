#pragma once

#include <atomic>
#include <chrono>
#include <libusb.h>
#include <poll.h>
#include <vector>

namespace palpate
{
/// Waits until a libusb context has events or another thread calls Wake, which neither locks nor
/// allocates. For one waiting thread.
class LibusbPoll
{
public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// Keeps the context, which must outlive it and be used by no other such object.
  explicit LibusbPoll(libusb_context* context);
  ~LibusbPoll();
  LibusbPoll(const LibusbPoll&) = delete;
  LibusbPoll& operator=(const LibusbPoll&) = delete;

  /// False if the system provided no descriptor.
  bool IsUsable() const noexcept { return this->WakeDescriptor >= 0; }
  /// Ends the current or the next wait. Any thread.
  void Wake() noexcept;
  /// Waits at most until then. `withDevice` is false if the device is gone, since its descriptor
  /// stays ready for ever.
  void Wait(TimePoint until, bool withDevice) noexcept;

private:
  void Fetch();

  libusb_context* Context;
  int WakeDescriptor;
  std::vector<pollfd> Set; // the first is the wake-up descriptor
  std::atomic<bool> IsOld{true};
};
} // namespace palpate
