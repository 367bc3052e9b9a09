#pragma once

#include "RampIn.h"
#include "Vector3.h"

namespace palpate
{
/// s, for the handover from one contact to another. A step of the largest force of a small device
/// (8 N) then changes as slowly as pressing a wall of 1 N/mm with 80 mm/s, at a twenty-fifth of the
/// slew limit, and ends before a voluntary reaction.
inline constexpr double HandoverDuration = 0.1;

/// A former contact whose force fades out while that of its replacement fades in. It stays in place
/// as a plane with a spring: its force continues without a step, depends on the hand's position,
/// and ends for good when the hand has left the plane, so that no force remains without a wall. All
/// in the device's frame.
class FadingContact
{
public:
  /// No contact.
  FadingContact() noexcept : Progress(0.0) {}
  /// A contact that exerted `force` (N) with the hand at `hand` (mm), along the unit vector
  /// `normal` with `stiffness` (N/mm). A force that does not push along the normal counts as no
  /// contact.
  FadingContact(const Vector3& force, const Vector3& normal, double stiffness,
                const Vector3& hand) noexcept;

  /// The force (N) with the hand at `hand`, `passed` (s) after the last call; the first call
  /// returns the full force.
  Vector3 Advance(const Vector3& hand, double passed) noexcept;
  bool IsOver() const noexcept { return !(this->Push > 0.0); }
  /// N, of the last call.
  Vector3 Force() const noexcept;
  /// The sum of both current forces as one contact, which then begins to fade: for a replacement
  /// before they have faded, so that no force is lost.
  static FadingContact Joined(const FadingContact& one, const FadingContact& other) noexcept;

private:
  RampIn Progress; // of the replacement
  double Weight = 1.0;
  double Push = 0.0; // N, along the normal
  double Stiffness = 0.0;
  Vector3 Normal = Vector3::UnitZ();
  Vector3 Slip = Vector3::Zero(); // the rest of the force, relative to the push
  Vector3 Hand = Vector3::Zero(); // mm, when Push was computed
};
} // namespace palpate
