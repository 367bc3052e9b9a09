#pragma once

#include "RampIn.h"
#include "Vector3.h"

namespace palpate
{
/// s, in which one contact takes the place of another. A step of the largest force of a small
/// device (8 N) then changes as slowly as pressing a wall of 1 N/mm with 80 mm/s, a twenty-fifth of
/// what the slew limit lets pass, and it is over before a hand could answer by will.
inline constexpr double HandoverDuration = 0.1;

/// A contact that nothing is asked about any more, felt less and less while what takes its place is
/// felt more and more. It stays where it was as a plane with a spring: its force goes on from what
/// it was, follows the hand, and ends for good as soon as the hand has left the plane, so that no
/// force is left over without a wall. All in the device's frame.
class FadingContact
{
public:
  /// None.
  FadingContact() noexcept : Progress(0.0) {}
  /// What gave `force` (N) when the hand was at `hand` (mm), along the unit vector `normal` with
  /// `stiffness` (N/mm). A force that does not push along the normal is none.
  FadingContact(const Vector3& force, const Vector3& normal, double stiffness,
                const Vector3& hand) noexcept;

  /// The force (N) with the hand at `hand`, `passed` (s) after the last call; the first one begins
  /// with all of it.
  Vector3 Advance(const Vector3& hand, double passed) noexcept;
  bool IsOver() const noexcept { return !(this->Push > 0.0); }
  /// N, of the last call.
  Vector3 Force() const noexcept;
  /// What both give now as one, which begins to fade with all of that: where something takes their
  /// place before they have faded, nothing is missing meanwhile.
  static FadingContact Joined(const FadingContact& one, const FadingContact& other) noexcept;

private:
  RampIn Progress; // of what takes its place
  double Weight = 1.0;
  double Push = 0.0; // N, along the normal
  double Stiffness = 0.0;
  Vector3 Normal = Vector3::UnitZ();
  Vector3 Slip = Vector3::Zero(); // the rest of the force, as part of the push
  Vector3 Hand = Vector3::Zero(); // mm, for Push
};
} // namespace palpate
