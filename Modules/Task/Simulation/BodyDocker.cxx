#include "BodyDocker.h"

#include "HeldPose.h"
#include "Units.h"

#include <utility>

namespace palpate
{
namespace
{
constexpr int MostRounds = 8;
constexpr double LeastSeenShift = 1.0; // mm, that is corrected
constexpr double LeastSeenTurn = 2.0;  // degrees
constexpr double TurnSeconds = 1.5;    // of a drag that turns
constexpr double RestSeconds = 0.4;    // until the hand has yielded to what it feels

Vector3 RotationVector(const Matrix3& rotation)
{
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}
} // namespace

Eigen::Affine3d BodyDocker::Dock(const Eigen::Affine3d& place)
{
  this->Hold(Eigen::Affine3d::Identity());
  for (int round = 0; round < MostRounds && !this->Hand.Watched().IsOver(); ++round)
  {
    const Vector3 turn = RotationVector(place.linear() * this->Pose().linear().transpose()) +
                         this->Hand.Errors(this->Skill.SeenTurnDeviation / DegreesPerRadian);
    const Vector3 middle = place * this->Fit->Pivot();
    const Vector3 shift =
        middle - this->Pose() * this->Fit->Pivot() + this->Hand.Errors(this->Skill.AimDeviation);
    const bool isTurned = turn.norm() >= LeastSeenTurn / DegreesPerRadian;
    const bool isShifted = shift.norm() >= LeastSeenShift;
    if (isTurned)
    {
      this->Turn(turn);
    }
    if (isShifted)
    {
      this->Hand.MoveTo(this->Hand.AimWorld() + shift);
      this->Hand.Hold(RestSeconds);
    }
    if (!isTurned && !isShifted)
    {
      break;
    }
  }
  return this->Pose();
}

void BodyDocker::Hold(const Eigen::Affine3d& pose)
{
  this->Held = std::make_shared<const HeldField>(this->Fit, pose, this->Hand.ProbeWorld());
  TouchScene scene = this->Hand.FirstScene();
  scene.Structures.clear();
  scene.Fields = {this->Held};
  this->Hand.Feel(std::move(scene));
}

// About the body's middle, which stays.
void BodyDocker::Turn(const Vector3& rotation)
{
  HeldPose turned(*this->Fit, this->Fit->Stiffness(), this->Pose());
  turned.Turn(rotation);
  this->Hold(turned.Pose());
  this->Hand.Hold(TurnSeconds);
}
} // namespace palpate
