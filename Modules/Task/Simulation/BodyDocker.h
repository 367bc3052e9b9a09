#pragma once

#include "HandSkill.h"
#include "HeldField.h"
#include "TaskHand.h"
#include "TaskSettings.h"

#include <memory>

namespace palpate
{
/// A simulated hand that docks a body: it holds it at the tool, turns it by a pointer, and brings
/// it to where it belongs by what it sees of its pose (HandSkill), again and again until nothing
/// seems to be off. With force it feels how the body fits.
class BodyDocker
{
public:
  /// Keeps the addresses of the hand and its skill.
  BodyDocker(TaskHand& hand, const HandSkill& skill, std::shared_ptr<const HeldFit> fit)
      : Hand(hand), Skill(skill), Fit(std::move(fit))
  {
  }

  /// A map of the world (mm) from where the body was.
  Eigen::Affine3d Dock(const Eigen::Affine3d& place);

private:
  void Hold(const Eigen::Affine3d& pose);
  void Turn(const Vector3& rotation);
  Eigen::Affine3d Pose() const { return this->Held->PoseAt(this->Hand.ProbeWorld()); }

  TaskHand& Hand;
  const HandSkill& Skill;
  std::shared_ptr<const HeldFit> Fit;
  std::shared_ptr<const HeldField> Held;
};
} // namespace palpate
