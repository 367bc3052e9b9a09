#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <type_traits>

namespace palpate
{
/// Hands the newest value from one thread to one other. Neither ever waits, and no value is read
/// half-written: the writer owns one of three slots, the reader another, and the third, with which
/// either swaps its own, holds the newest. Values that were not read in time are lost by design.
template <typename T>
class LatestValue
{
  static_assert(std::is_trivially_copyable_v<T>, "copies of values must not allocate or throw");

public:
  explicit LatestValue(const T& first = T()) noexcept { this->Slots.fill({first}); }

  /// Writing thread only.
  void Publish(const T& value) noexcept
  {
    this->Slots[this->Back].Value = value;
    this->Back = this->Shared.exchange(this->Back | Fresh, std::memory_order_acq_rel) & Index;
  }

  /// Reading thread only: the newest value, valid until the next call.
  const T& Latest() noexcept
  {
    if ((this->Shared.load(std::memory_order_relaxed) & Fresh) != 0)
    {
      this->Front = this->Shared.exchange(this->Front, std::memory_order_acq_rel) & Index;
    }
    return this->Slots[this->Front].Value;
  }

private:
  static constexpr unsigned Index = 3;
  static constexpr unsigned Fresh = 4; // set until the reader has seen the shared slot

  // On separate cache lines, so that the two threads do not slow each other down.
  struct alignas(64) Slot
  {
    T Value;
  };
  std::array<Slot, 3> Slots;
  alignas(64) std::atomic<unsigned> Shared{1};
  alignas(64) unsigned Back = 0;  // the writer's
  alignas(64) unsigned Front = 2; // the reader's
};
} // namespace palpate
