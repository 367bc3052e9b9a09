#include "StudyPlan.h"

#include "FileStamp.h"
#include "SceneReading.h"

namespace palpate
{
SceneStamps StampFiles(const StudyState& state)
{
  std::vector<std::filesystem::path> files{state.VolumeFile, state.SegmentationFile};
  if (state.Tool.Kind == TouchToolSettings::Shape::Surface)
  {
    files.push_back(state.Tool.File);
  }
  for (const SceneStructure& structure : state.Structures)
  {
    files.push_back(structure.File);
    files.push_back(structure.WithinFile);
    for (const auto& [key, image] : structure.Images)
    {
      files.push_back(image);
    }
  }
  SceneStamps stamps;
  for (const std::filesystem::path& file : files)
  {
    if (!file.empty() && stamps.count(file) == 0)
    {
      stamps[file] = StampOf(file);
    }
  }
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
  if (!state.SegmentationFile.empty())
  {
    nodes.push_back(SegmentationNode(state.SegmentationFile, state.LeftHanded, stamps));
  }
  PlanScene(state, stamps, lookup, true, nodes);
  return nodes;
}
} // namespace palpate
