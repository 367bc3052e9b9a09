#pragma once

#include "Contact.h"
#include "ToolPose.h"

#include <cstddef>

namespace palpate
{
class FieldSolid;

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
  /// Whether drilling may change what is followed: the next four members are for that alone.
  virtual bool CanBeDrilled() const noexcept { return false; }
  /// Follows another version of its solid from now on and keeps the proxy. `solid` must live until
  /// the next one is given.
  virtual void UseSolid(const FieldSolid&) noexcept {}
  /// Whether the tool at `pose` is nowhere inside. Only after Release.
  virtual bool IsFreeAt(const ToolPose&) noexcept { return true; }
  /// How far (mm) a proxy on the surface may be inside by rounding, at most.
  virtual double SurfaceTolerance() const noexcept { return 0.0; }
  /// What it occupies beside its model; 0 where it does not say.
  virtual std::size_t Bytes() const noexcept { return 0; }

protected:
  ContactTracker() = default;
};
} // namespace palpate
