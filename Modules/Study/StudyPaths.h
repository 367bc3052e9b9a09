#pragma once

#include "StudyState.h"

namespace palpate
{
/// Calls `visit(role, path)` for every file that a state may name, also for empty paths; roles as
/// in StudyMissingFile. `State` is StudyState or const StudyState.
template <typename State, typename Function>
void ForEachPath(State& state, const Function& visit)
{
  visit("volume", state.VolumeFile);
  visit("segmentation", state.SegmentationFile);
  visit("tool", state.Tool.File);
  visit("prior", state.Drawing.PriorFile);
  for (auto& volume : state.Volumes)
  {
    visit("volume", volume.File);
    visit("transform", volume.Transform);
  }
  for (auto& structure : state.Structures)
  {
    visit("structure", structure.File);
    visit("segmentation", structure.WithinFile);
    visit("transform", structure.Move.File);
    visit("volume", structure.Move.Fixed);
    for (auto& [key, image] : structure.Images)
    {
      visit(key.c_str(), image);
    }
  }
}
} // namespace palpate
