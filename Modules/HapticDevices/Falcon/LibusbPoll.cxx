#include "LibusbPoll.h"

#include <algorithm>
#include <cstdint>
#include <sys/eventfd.h>
#include <unistd.h>

namespace palpate
{
LibusbPoll::LibusbPoll(libusb_context* context)
    : Context(context), WakeDescriptor(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC))
{
  libusb_set_pollfd_notifiers(
      context, [](int, short, void* poll) { static_cast<LibusbPoll*>(poll)->IsOld = true; },
      [](int, void* poll) { static_cast<LibusbPoll*>(poll)->IsOld = true; }, this);
}

LibusbPoll::~LibusbPoll()
{
  libusb_set_pollfd_notifiers(this->Context, nullptr, nullptr, nullptr);
  if (this->IsUsable())
  {
    close(this->WakeDescriptor);
  }
}

void LibusbPoll::Wake() noexcept
{
  const std::uint64_t one = 1;
  // If it fails, 2^64 wake-ups are pending already.
  static_cast<void>(!write(this->WakeDescriptor, &one, sizeof(one)));
}

void LibusbPoll::Fetch()
{
  this->Set.assign(1, {this->WakeDescriptor, POLLIN, 0});
  const libusb_pollfd** const descriptors = libusb_get_pollfds(this->Context);
  for (const libusb_pollfd* const* one = descriptors; one != nullptr && *one != nullptr; ++one)
  {
    this->Set.push_back({(*one)->fd, (*one)->events, 0});
  }
  libusb_free_pollfds(descriptors);
}

void LibusbPoll::Wait(TimePoint until, bool withDevice) noexcept
{
  if (this->IsOld.exchange(false))
  {
    this->Fetch();
  }
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
      until - std::chrono::steady_clock::now());
  constexpr std::int64_t WithoutDevice = 10; // ms; libusb is still polled for finished transfers
  const std::int64_t time = std::max<std::int64_t>(left.count() + 1, 0);
  poll(this->Set.data(), withDevice ? this->Set.size() : 1,
       static_cast<int>(withDevice ? time : std::min(time, WithoutDevice)));
  std::uint64_t ignored = 0;
  static_cast<void>(!read(this->WakeDescriptor, &ignored, sizeof(ignored)));
}
} // namespace palpate
