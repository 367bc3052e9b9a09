#include "KnownStructure.h"

#include "KnownOrgan.h"
#include "ModelFile.h"
#include "SceneLabels.h"
#include "SegmentationFile.h"

#include <algorithm>

namespace palpate
{
namespace
{
template <typename T>
T Placed(T read, const SceneStructure& structure)
{
  return structure.Move.IsSet()
             ? T(Moved(ReadMove(structure.Move, structure.File), std::move(read)))
             : read;
}

bool IsCalled(const SceneStructure& structure, const std::string& name)
{
  const bool hasLabel = structure.Labels.size() == 1 && structure.Labels.front() == name;
  return CanBeKnown(structure) && (hasLabel || TitleOf(structure) == name);
}
} // namespace

bool CanBeKnown(const SceneStructure& structure)
{
  const SceneSource source = structure.Source();
  return source == SceneSource::Model ||
         (source == SceneSource::Label && structure.Labels.size() == 1);
}

const SceneStructure* KnownStructure(const StudyState& state, const OrganRelation& relation)
{
  const int id = state.Drawing.KnownId;
  if (id != StudyDrawing::KnownByName)
  {
    const SceneStructure* chosen = FindStructure(state, id);
    return chosen != nullptr && CanBeKnown(*chosen) ? chosen : nullptr;
  }
  const auto isCalled = [&relation](const SceneStructure& one)
  { return IsCalled(one, relation.Name); };
  const auto& all = state.Structures;
  const auto found = std::find_if(all.begin(), all.end(), isCalled);
  const bool isOne = found != all.end() && std::count_if(found, all.end(), isCalled) == 1;
  return isOne && !relation.Name.empty() ? &*found : nullptr;
}

LogSurface ReadKnownStructure(const SceneStructure& structure, LeftHandedAxes leftHanded)
{
  if (structure.Source() == SceneSource::Model)
  {
    return KnownOrganOf(Placed(ReadModel(structure.File).Surface, structure), structure.File);
  }
  const Segmentation read = Placed(ReadSegmentation(structure.File, leftHanded), structure);
  return FitKnownOrgan(read, SegmentOf(structure, read), structure.File);
}
} // namespace palpate
