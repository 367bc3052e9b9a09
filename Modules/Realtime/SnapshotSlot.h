#pragma once

#include "RingBuffer.h"

#include <atomic>
#include <memory>
#include <utility>

namespace palpate
{
/// Hands whole objects from a publishing thread to the servo thread. The servo takes the newest
/// without lock, allocation or destruction; what it no longer uses goes back and is destroyed by
/// the publisher. Both threads must have stopped using it before it is destroyed itself.
template <typename T>
class SnapshotSlot
{
public:
  SnapshotSlot() = default;
  SnapshotSlot(const SnapshotSlot&) = delete;
  SnapshotSlot& operator=(const SnapshotSlot&) = delete;
  ~SnapshotSlot()
  {
    this->Reclaim();
    delete this->Pending.load(std::memory_order_acquire);
    delete this->Used;
  }

  /// By the publisher: the servo has it from its next Refresh on. One that it never took is
  /// destroyed here. An empty pointer is ignored.
  void Publish(std::unique_ptr<T> next)
  {
    this->Reclaim();
    if (next != nullptr)
    {
      delete this->Pending.exchange(next.release(), std::memory_order_acq_rel);
    }
  }

  /// By the publisher: destroys what the servo has given back; Publish does it too.
  void Reclaim() noexcept
  {
    T* retired = nullptr;
    while (this->Retired.Pop(retired))
    {
      delete retired;
    }
  }

  /// By the servo: takes the newest object; false where there is none newer.
  bool Refresh() noexcept
  {
    return this->Refresh([](const T*, T&) noexcept {});
  }

  /// The same; before the last one goes back, handOver(last, next) takes over what is to go on. The
  /// last one is empty at the first time.
  template <typename HandOver>
  bool Refresh(const HandOver& handOver) noexcept
  {
    if (this->Pending.load(std::memory_order_relaxed) == nullptr)
    {
      return false;
    }
    T* const next = this->Pending.exchange(nullptr, std::memory_order_acq_rel);
    handOver(static_cast<const T*>(this->Used), *next);
    if (this->Used != nullptr)
    {
      // Never full: Publish reclaims, and at most two objects are taken between its reclaiming and
      // the end of its next one.
      this->Retired.Push(this->Used);
    }
    this->Used = next;
    return true;
  }

  /// By the servo: what the last Refresh that found something took; empty before.
  T* Current() noexcept { return this->Used; }

private:
  std::atomic<T*> Pending{nullptr};
  T* Used = nullptr; // the servo's
  RingBuffer<T*> Retired{4};
};
} // namespace palpate
