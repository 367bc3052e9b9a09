#include "TrialState.h"

#include "StudyStructures.h"

namespace palpate
{
StudyState TrialState(const StudyState& first, const std::string& device, TaskKind kind,
                      const TaskTarget& target, const TaskCondition& condition)
{
  const SceneSettings scene = ReadWholeScene(target.Scene, first.LeftHanded, condition.Patch);
  StudyState state = WithScene(first, scene);
  state.Device = scene.Device == SceneSettings().Device ? device : scene.Device;
  // What is drawn by touch is the answer, and not what is touched.
  state.Drawing.IsTouchable = false;
  for (SceneStructure& structure : state.Structures)
  {
    if (kind == TaskKind::Nodule)
    {
      structure.IsVisible = structure.IsVisible && structure.IsTouchable;
      structure.Appearance = SceneAppearance::Automatic; // no map of the stiffness
    }
  }
  return state;
}
} // namespace palpate
