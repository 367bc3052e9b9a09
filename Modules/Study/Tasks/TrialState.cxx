#include "TrialState.h"

#include "MaskTruth.h"
#include "StudyStructures.h"
#include "TargetScene.h"

namespace palpate
{
StudyState TrialState(const StudyState& first, const std::string& device, TaskKind kind,
                      const TaskTarget& target, const TaskCondition& condition)
{
  const SceneSettings scene = ReadWholeScene(target.Scene, first.LeftHanded, condition.Patch);
  CheckTarget(kind, target, scene);
  StudyState state = WithScene(first, scene);
  if (!target.Image.empty())
  {
    state.VolumeFile = StudyPath(target.Image);
  }
  if (kind == TaskKind::Mask)
  {
    state.Correction = {CorrectedStructure(target, state).Id, {}, NeighborPolicy::Stop};
    state.View.OverlayOpacity = 0.0; // what is corrected has an outline; the image is to be seen
  }
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
