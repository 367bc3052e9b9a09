#pragma once

#include "Contact.h"
#include "ToolPose.h"

#include <cstddef>

namespace palpate
{
/// Follows one tool at one structure from tick to tick: remembers the proxy, so that it is coherent
/// and never crosses the surface, however fast the probe moves. One for each servo thread. Neither
/// allocates nor locks after it was made.
class ContactTracker
{
public:
  virtual ~ContactTracker() = default;
  ContactTracker(const ContactTracker&) = delete;
  ContactTracker& operator=(const ContactTracker&) = delete;

  /// One tick. The result holds until the next call.
  virtual const Contact& Follow(const ToolPose& pose) noexcept = 0;
  /// Forgets the proxy: the next tick starts afresh, wherever the tool is by then.
  virtual void Release() noexcept = 0;
  /// Whether it can be followed now; what it needs is then there until Rest. Asked before every
  /// Follow where it may not be.
  virtual bool IsAtHand() noexcept { return true; }
  /// It is not followed for now, and nothing needs to be there for it.
  virtual void Rest() noexcept {}
  /// What it occupies beside its model; 0 where it does not say.
  virtual std::size_t Bytes() const noexcept { return 0; }

protected:
  ContactTracker() = default;
};
} // namespace palpate
