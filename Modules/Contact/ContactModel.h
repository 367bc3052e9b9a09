#pragma once

#include "ContactTracker.h"
#include "Status.h"
#include "SurfaceFriction.h"
#include "ToolShape.h"
#include "Vector3.h"

#include <cstddef>
#include <memory>

namespace palpate
{
class ToolGaps;

/// Touch model of a structure. Immutable, so threads can share it as a snapshot.
class ContactModel
{
public:
  virtual ~ContactModel() = default;
  ContactModel(const ContactModel&) = delete;
  ContactModel& operator=(const ContactModel&) = delete;

  /// Contains the whole structure, mm; a tool farther from it than its BoundingRadius has no
  /// contact.
  virtual Eigen::AlignedBox3d BoundsWorld() const noexcept = 0;

  /// Creates a tracker for `tool`. It shares this model's data and may outlive it. Fails, with
  /// `tracker` unchanged, for an invalid tool or friction, and for tools that this kind of model
  /// does not support. Allocates: never call it in a tick.
  virtual Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                             std::unique_ptr<ContactTracker>& tracker) const = 0;

  /// Creates what keeps a tool of several balls (ToolShape::Skeleton) out of the structure, for a
  /// SharedProxy. As MakeTracker.
  virtual Status MakeGaps(const ToolShape&, const SurfaceFriction&,
                          std::unique_ptr<ToolGaps>&) const
  {
    return Status::Failure("it is touched by spheres and points only.");
  }

  /// Of a structure that yields, about the largest stiffness (N/mm) that a tool meets; 0 where the
  /// force law of the scene decides. Takes some milliseconds.
  virtual double OwnStiffness(const ToolShape&) const { return 0.0; }

  /// Memory with shared data, without trackers; 0 if unknown.
  virtual std::size_t Bytes() const noexcept { return 0; }

protected:
  ContactModel() = default;
};
} // namespace palpate
