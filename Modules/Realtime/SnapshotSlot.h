#pragma once

#include "RingBuffer.h"

#include <atomic>
#include <memory>
#include <utility>

namespace palpate
{
/// Hands whole objects from a publishing thread to the servo thread. The servo takes the newest
/// without locking, allocating or destroying; objects that it no longer uses go back and are
/// destroyed by the publisher. Both threads must have stopped using the slot before it is
/// destroyed.
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

  /// Publisher only: the servo gets the object at its next Refresh. An object that it never took is
  /// destroyed here. An empty pointer is ignored.
  void Publish(std::unique_ptr<T> next)
  {
    this->Reclaim();
    if (next != nullptr)
    {
      delete this->Pending.exchange(next.release(), std::memory_order_acq_rel);
    }
  }

  /// Publisher only: destroys the objects that the servo has returned; Publish does so too.
  void Reclaim() noexcept
  {
    T* retired = nullptr;
    while (this->Retired.Pop(retired))
    {
      delete retired;
    }
  }

  /// Servo only: takes the newest object; returns false if there is no newer one.
  bool Refresh() noexcept
  {
    return this->Refresh([](const T*, T&) noexcept {});
  }

  /// The same; before the former object is returned, handOver(former, next) carries its state over.
  /// `former` is null the first time.
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
      // the end of the next Publish.
      this->Retired.Push(this->Used);
    }
    this->Used = next;
    return true;
  }

  /// Servo only: the object taken last; null before the first.
  T* Current() noexcept { return this->Used; }

private:
  std::atomic<T*> Pending{nullptr};
  T* Used = nullptr; // servo thread
  RingBuffer<T*> Retired{4};
};
} // namespace palpate
