#include "SceneLabels.h"

#include "FitStructure.h"
#include "Refusal.h"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace palpate
{
namespace
{
// Larger than any label's number.
constexpr int FirstFreeId = 1'000'000'001;

// Of several masks, each has a label 1: its file's name tells them apart.
std::string NameFromFile(const SceneStructure& entry, const Segment& segment, bool isOne)
{
  const std::string name = CaseNameOf(entry.File);
  return isOne ? name : name + " " + std::to_string(segment.Label);
}

void AddSegments(const SceneStructure& entry, const Segmentation& segmentation, bool isAmongSeveral,
                 std::vector<SceneStructure>& structures)
{
  const std::vector<Segment> segments = SegmentsOf(entry, segmentation);
  const bool isOne = segments.size() == 1;
  for (const Segment& segment : segments)
  {
    SceneStructure structure = entry;
    structure.Labels = {std::to_string(segment.Label)};
    structure.Id = isOne ? entry.Id : 0;
    structure.Name = entry.Name.empty() ? segment.Name : entry.Name;
    if (structure.Name.empty() && isAmongSeveral)
    {
      structure.Name = NameFromFile(entry, segment, isOne);
    }
    structure.Color = entry.Color == SceneStructure().Color ? segment.Color : entry.Color;
    structures.push_back(std::move(structure));
  }
}

void GiveIds(std::vector<SceneStructure>& structures)
{
  std::set<int> taken{0};
  for (SceneStructure& structure : structures)
  {
    structure.Id = taken.insert(structure.Id).second ? structure.Id : 0;
  }
  int next = FirstFreeId;
  for (SceneStructure& structure : structures)
  {
    const bool isLabel = structure.Source() == SceneSource::Label && structure.Labels.size() == 1;
    const int label = isLabel ? std::atoi(structure.Labels.front().c_str()) : 0;
    if (structure.Id == 0 && taken.insert(label).second)
    {
      structure.Id = label;
    }
    while (structure.Id == 0)
    {
      structure.Id = taken.insert(next).second ? next : 0;
      ++next;
    }
  }
}
} // namespace

SceneSettings ResolveLabels(const SceneSettings& scene, bool isSeen, const SegmentationReader& read)
{
  SceneSettings resolved = scene;
  resolved.Structures.clear();
  const bool isGuided =
      std::any_of(scene.Guides.begin(), scene.Guides.end(),
                  [](const GuideSettings& guide) { return guide.HasStructure(); });
  std::set<std::filesystem::path> masks;
  for (const SceneStructure& entry : scene.Structures)
  {
    if (entry.Source() == SceneSource::Label)
    {
      masks.insert(entry.File);
    }
  }
  for (const SceneStructure& entry : scene.Structures)
  {
    if (entry.Source() != SceneSource::Label && !entry.Labels.empty())
    {
      Refuse(entry.File,
             "is not taken for a segmentation, so that it has no label " + entry.Labels.front(),
             "leave the label out");
    }
    const bool isNeeded =
        (entry.IsVisible && isSeen) || entry.IsTouchable || entry.IsForbidden || isGuided;
    if (isNeeded && entry.Source() == SceneSource::Label)
    {
      AddSegments(entry, *read(entry.File), masks.size() > 1, resolved.Structures);
    }
    else
    {
      resolved.Structures.push_back(entry);
    }
  }
  GiveIds(resolved.Structures);
  return resolved;
}

std::vector<Segment> SegmentsOf(const SceneStructure& structure, const Segmentation& segmentation)
{
  if (structure.Labels.empty())
  {
    return segmentation.Segments;
  }
  std::vector<Segment> segments;
  for (const std::string& label : structure.Labels)
  {
    segments.push_back(segmentation.Find(label));
  }
  return segments;
}

const Segment& SegmentOf(const SceneStructure& structure, const Segmentation& segmentation)
{
  return segmentation.Find(structure.Labels.empty() ? std::string() : structure.Labels.front());
}
} // namespace palpate
