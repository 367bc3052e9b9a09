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
/// A structure as something to touch. Immutable, so it can be shared by threads as a snapshot.
class ContactModel
{
public:
  virtual ~ContactModel() = default;
  ContactModel(const ContactModel&) = delete;
  ContactModel& operator=(const ContactModel&) = delete;

  /// Holds the whole structure, mm; a tool that is farther from it than its BoundingRadius touches
  /// nothing.
  virtual Eigen::AlignedBox3d BoundsWorld() const noexcept = 0;

  /// What follows `tool` here. It shares this model's data and may outlive it. Refuses, with
  /// `tracker` untouched, a tool or a friction that is none, and a tool that this kind of model
  /// cannot feel. Allocates: never in a tick.
  virtual Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                             std::unique_ptr<ContactTracker>& tracker) const = 0;

  /// What it occupies with what it shares, without its trackers; 0 where it does not say.
  virtual std::size_t Bytes() const noexcept { return 0; }

protected:
  ContactModel() = default;
};
} // namespace palpate
