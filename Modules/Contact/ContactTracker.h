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

  /// One tick. The result is valid until the next call.
  virtual const Contact& Follow(const ToolPose& pose) noexcept = 0;
  /// Forgets the proxy: the next tick starts from the tool's position then.
  virtual void Release() noexcept = 0;
  /// Whether no part of the tool at `pose` is inside. Call only after Release; an unusable pose is
  /// not free.
  virtual bool IsFreeAt(const ToolPose& pose) noexcept = 0;
  /// Largest depth (mm) of a proxy on the surface due to rounding: a tool that is moved out by as
  /// much is free.
  virtual double SurfaceTolerance() const noexcept { return 0.0; }
  /// Whether the structure may be drilled; the next member is for that only.
  virtual bool CanBeDrilled() const noexcept { return false; }
  /// Uses another version of the solid from now on and keeps the proxy. `solid` must live until the
  /// next one is set.
  virtual void UseSolid(const FieldSolid&) noexcept {}
  /// Memory without the model; 0 if unknown.
  virtual std::size_t Bytes() const noexcept { return 0; }

protected:
  ContactTracker() = default;
};
} // namespace palpate
