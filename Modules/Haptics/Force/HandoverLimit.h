#pragma once

#include "ToolWrench.h"

namespace palpate
{
/// Keeps force and torque of a hand at or below what they were when another scene took over,
/// whatever that scene changed: a resting hand is never pushed or twisted harder because a program
/// changed something. Pushing on raises the limits by the stiffness times the distance, and
/// retreating lowers them, so a contact feels like a spring that begins where the hand is. Each
/// limit ends once it has not been needed for a while, as when the tool has left. All in the
/// device's frame.
///
/// Coupled by planes, a wrench changes by the stiffness times a projection of the hand's motion, if
/// turns are counted as shifts by the tool's gyration (see RigidProxy). So a turn changes the
/// force, and a shift the torque, by no more than half as much as a motion of its own kind: the
/// norm of the off-diagonal part of a projection.
class HandoverLimit
{
public:
  /// No limit.
  HandoverLimit() noexcept = default;
  /// After a scene whose contacts exerted `wrench` with the hand at `hand` (mm), turned by `turn`.
  HandoverLimit(const ToolWrench& wrench, const Vector3& hand,
                const Eigen::Quaterniond& turn) noexcept
      : OfForce{wrench.Force.norm()}, OfTorque{wrench.Torque.norm()}, Hand(hand), Turn(turn)
  {
  }

  bool IsOver() const noexcept { return !this->OfForce.IsActive && !this->OfTorque.IsActive; }
  /// `wrench`, each part shortened if necessary, of contacts of `stiffness` (N/mm) and a tool of
  /// `gyration` (mm of the hand; 0 if it shows no torque), with the hand at `hand` (mm), turned by
  /// `turn`, `passed` (s) after the last call.
  ToolWrench Limited(const ToolWrench& wrench, double stiffness, double gyration,
                     const Vector3& hand, const Eigen::Quaterniond& turn, double passed) noexcept;

private:
  // Of the force or of the torque.
  struct Part
  {
    double Most = 0.0; // N or N mm
    bool IsActive = true;
    double Unneeded = 0.0; // s, so far

    Vector3 Limited(const Vector3& value, double raised, double passed) noexcept;
  };

  Part OfForce{0.0, false};
  Part OfTorque{0.0, false};
  Vector3 Hand = Vector3::Zero();
  Eigen::Quaterniond Turn = Eigen::Quaterniond::Identity();
};
} // namespace palpate
