#pragma once

#include "PalpateTaskModule.h"
#include "PalpationSearch.h"
#include "SceneSettings.h"
#include "TaskConduct.h"
#include "TaskHand.h"
#include "TaskSettings.h"

#include <cstdint>

namespace palpate
{
/// Does one trial with a hand as a person would, with what the task shows and the hand feels:
/// - nodule: presses a raster of places on the side that is palpated, comes back to the hardest
///   ones, and reports the hardest if it is noticeably harder than most; then presses around it to
///   see how far the hardness reaches (PalpationSearch);
/// - landmarks: moves to each place as it is seen, and on until the surface is felt;
/// - outline: follows the outline as it is seen, in the condition with force along the surface;
/// - path: follows it as it is seen, and goes back from what is touched;
/// - mask: pulls the surface to the organ's edge as it is seen (MaskPuller);
/// - dock: brings the body to its place as it is seen, and to where it is felt to fit (BodyDocker).
/// The hand knows where landmarks, outlines and paths are since they are displayed; nothing tells
/// it of a nodule.
class PALPATETASK_EXPORT SimulatedParticipant
{
public:
  /// Keeps the addresses of the hand and of the scene, which the hand holds. `seed`: of choices.
  SimulatedParticipant(TaskHand& hand, const HandSkill& skill, std::uint64_t seed,
                       const SceneSettings& scene)
      : Hand(hand), Skill(skill), Seed(seed), Scene(scene)
  {
  }

  /// Throws InputError if the target's files cannot be read, and FilterError.
  TaskAnswer Do(TaskKind kind, const TaskTarget& target);

private:
  TaskAnswer FindNodule(const TaskTarget& target);
  double SizeOf(const TaskTarget& target, const PalpationSearch::Finding& finding);
  double Press(const TaskTarget& target, const FreePlace& place);
  TaskAnswer MarkLandmarks(const TaskTarget& target);
  Vector3 Mark(const Vector3& pointWorld);
  TaskAnswer DrawOutline(const TaskTarget& target);
  TaskAnswer FollowPath(const TaskTarget& target);
  TaskAnswer CorrectMask(const TaskTarget& target);
  TaskAnswer DockBody(const TaskTarget& target);

  TaskHand& Hand;
  HandSkill Skill;
  std::uint64_t Seed;
  const SceneSettings& Scene;
  Vector3 Pressed = Vector3::Zero(); // world, where the surface was pressed last
};
} // namespace palpate
