#include "StudyPlan.h"

#include "FileStamp.h"
#include "SceneReading.h"
#include "StudyPaths.h"

namespace palpate
{
SceneStamps StampFiles(const StudyState& state)
{
  SceneStamps stamps;
  ForEachPath(state,
              [&stamps](const char*, const std::filesystem::path& file)
              {
                if (!file.empty() && stamps.count(file) == 0)
                {
                  stamps[file] = StampOf(file);
                }
              });
  return stamps;
}

std::vector<SceneNode> PlanStudy(const StudyState& state, const SceneStamps& stamps,
                                 const SceneLookup& lookup)
{
  std::vector<SceneNode> nodes;
  if (!state.VolumeFile.empty())
  {
    nodes.push_back(VolumeNode(state.VolumeFile, state.DicomSeries, state.LeftHanded, stamps));
  }
  for (const StudyVolume& volume : state.Volumes)
  {
    if (volume.IsVisible)
    {
      nodes.push_back(
          VolumeNode(volume.File, volume.Series, state.LeftHanded, stamps, MoveOf(state, volume)));
      nodes.back().Id = volume.Id;
    }
  }
  if (!state.SegmentationFile.empty())
  {
    nodes.push_back(SegmentationNode(state.SegmentationFile, state.LeftHanded, stamps));
  }
  PlanScene(state, stamps, lookup, true, nodes);
  return nodes;
}
} // namespace palpate
