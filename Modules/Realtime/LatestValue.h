#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <type_traits>

namespace palpate
{
/// Hands the newest value from one thread to one other. Neither ever waits, and nothing is read
/// half-written: of three slots the writer has one, the reader has one, and the third, which either
/// swaps for its own, holds the newest. Values that nobody read are lost, which is the purpose.
template <typename T>
class LatestValue
{
  static_assert(std::is_trivially_copyable_v<T>, "copies of values must not allocate or throw");

public:
  explicit LatestValue(const T& first = T()) noexcept { this->Slots.fill({first}); }

  /// By the writing thread.
  void Publish(const T& value) noexcept
  {
    this->Slots[this->Back].Value = value;
    this->Back = this->Middle.exchange(this->Back | Fresh, std::memory_order_acq_rel) & Index;
  }

  /// By the reading thread: the newest value; it keeps until the next call.
  const T& Latest() noexcept
  {
    if ((this->Middle.load(std::memory_order_relaxed) & Fresh) != 0)
    {
      this->Front = this->Middle.exchange(this->Front, std::memory_order_acq_rel) & Index;
    }
    return this->Slots[this->Front].Value;
  }

private:
  static constexpr unsigned Index = 3;
  static constexpr unsigned Fresh = 4; // set where the reader has not yet seen the middle slot

  // On lines of their own, so that the two threads do not slow each other down.
  struct alignas(64) Slot
  {
    T Value;
  };
  std::array<Slot, 3> Slots;
  alignas(64) std::atomic<unsigned> Middle{1};
  alignas(64) unsigned Back = 0;  // the writer's
  alignas(64) unsigned Front = 2; // the reader's
};
} // namespace palpate
