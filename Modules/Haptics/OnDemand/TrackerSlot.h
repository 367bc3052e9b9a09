#pragma once

#include "ContactTracker.h"

#include <atomic>
#include <memory>
#include <utility>

namespace palpate
{
/// Lends a tracker to the servo thread while what it follows is in memory. The servo holds it or
/// finds none, without lock, allocation or destruction; who lends it destroys it only while it is
/// not held. Both threads must have stopped using the slot before it is destroyed.
class TrackerSlot
{
public:
  /// By who lends, into an empty slot.
  void Put(std::unique_ptr<ContactTracker> tracker) noexcept
  {
    this->Lent = std::move(tracker);
    this->Now.store(State::Idle, std::memory_order_release);
  }
  /// By who lends: destroys the tracker unless it is held. Whether the slot is empty now.
  bool TryClear() noexcept
  {
    State found = State::Idle;
    if (this->Now.compare_exchange_strong(found, State::Empty, std::memory_order_acq_rel))
    {
      this->Lent.reset();
    }
    return found != State::Held;
  }
  bool IsEmpty() const noexcept
  {
    return this->Now.load(std::memory_order_relaxed) == State::Empty;
  }
  /// By who lends: whether the servo is to give it back as soon as it can do without.
  void AskBack(bool isAsked) noexcept { this->Asked.store(isAsked, std::memory_order_relaxed); }

  /// By the servo: the tracker until GiveBack; none where there is none or it is asked back.
  ContactTracker* Hold() noexcept
  {
    State found = State::Idle;
    const bool isHeld = !this->IsAskedBack() && this->Now.compare_exchange_strong(
                                                    found, State::Held, std::memory_order_acq_rel);
    return isHeld ? this->Lent.get() : nullptr;
  }
  void GiveBack() noexcept { this->Now.store(State::Idle, std::memory_order_release); }
  bool IsAskedBack() const noexcept { return this->Asked.load(std::memory_order_relaxed); }

private:
  enum class State
  {
    Empty,
    Idle,
    Held
  };

  std::atomic<State> Now{State::Empty};
  std::atomic<bool> Asked{false};
  std::unique_ptr<ContactTracker> Lent; // the lender's, but while it is held
};
} // namespace palpate
