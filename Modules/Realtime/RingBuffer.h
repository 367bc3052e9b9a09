#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace palpate
{
/// Hands every value from one thread to one other, in order, as long as the reader keeps up.
/// Neither ever waits; values that find the buffer full are dropped and counted.
template <typename T>
class RingBuffer
{
  static_assert(std::is_trivially_copyable_v<T>, "copies of values must not allocate or throw");

public:
  /// Holds `capacity` > 0 values; the only place that allocates.
  explicit RingBuffer(std::size_t capacity) : Slots(capacity > 0 ? capacity : 1) {}

  /// Writing thread only; returns false if the value was dropped.
  bool Push(const T& value) noexcept
  {
    const std::uint64_t written = this->Written.load(std::memory_order_relaxed);
    if (written - this->Read.load(std::memory_order_acquire) == this->Slots.size())
    {
      this->DropCount.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    this->Slots[written % this->Slots.size()] = value;
    this->Written.store(written + 1, std::memory_order_release);
    return true;
  }

  /// Reading thread only: takes the oldest value; returns false if empty.
  bool Pop(T& value) noexcept
  {
    const std::uint64_t read = this->Read.load(std::memory_order_relaxed);
    if (this->Written.load(std::memory_order_acquire) == read)
    {
      return false;
    }
    value = this->Slots[read % this->Slots.size()];
    this->Read.store(read + 1, std::memory_order_release);
    return true;
  }

  /// Number of values dropped so far.
  std::uint64_t Dropped() const noexcept { return this->DropCount.load(std::memory_order_relaxed); }

private:
  // Separate cache lines for writer and reader, so that the threads do not slow each other down.
  alignas(64) std::atomic<std::uint64_t> Written{0};
  std::atomic<std::uint64_t> DropCount{0};
  std::vector<T> Slots;
  alignas(64) std::atomic<std::uint64_t> Read{0};
};
} // namespace palpate
