#include "StructurePlaces.h"

#include "LabelCenters.h"
#include "VoxelValue.h"

#include <algorithm>

namespace palpate
{
void StructurePlaces::Take(const StudyState& state,
                           const std::shared_ptr<const Segmentation>& labels)
{
  if (labels != this->Labels)
  {
    this->Labels = labels;
    this->Centers.reset();
  }
  this->Ids.clear();
  this->Visible.clear();
  if (labels == nullptr)
  {
    return;
  }
  std::map<std::string, int> byText;
  for (const SceneStructure& structure : state.Structures)
  {
    if (structure.Labels.size() == 1 && structure.File == state.SegmentationFile &&
        !structure.Move.IsSet())
    {
      byText.emplace(structure.Labels.front(), structure.Id);
    }
    if (structure.IsVisible)
    {
      this->Visible.insert(structure.Id);
    }
  }
  for (const Segment& segment : labels->Segments)
  {
    const auto found = byText.find(std::to_string(segment.Label));
    if (found != byText.end())
    {
      this->Ids.emplace(segment.Label, found->second);
    }
  }
}

int StructurePlaces::IdOf(int label) const
{
  const auto found = this->Ids.find(label);
  return found != this->Ids.end() ? found->second : 0;
}

int StructurePlaces::At(const Vector3& pointWorld) const
{
  int last = 0;
  int layer = -1;
  for (std::size_t s = 0; this->Labels != nullptr && s < this->Labels->Segments.size(); ++s)
  {
    const Segment& segment = this->Labels->Segments[s];
    if (segment.Layer < layer || this->Visible.count(this->IdOf(segment.Label)) == 0)
    {
      continue;
    }
    const auto index = static_cast<std::size_t>(segment.Layer);
    const auto value = VoxelValueAt(this->Labels->Layers[index], pointWorld);
    if (value && *value == segment.Value)
    {
      last = this->IdOf(segment.Label);
      layer = segment.Layer;
    }
  }
  return last;
}

std::optional<Vector3> StructurePlaces::CenterOf(int id) const
{
  const auto label = std::find_if(this->Ids.begin(), this->Ids.end(),
                                  [id](const auto& one) { return one.second == id; });
  if (label == this->Ids.end())
  {
    return std::nullopt;
  }
  if (!this->Centers)
  {
    this->Centers = LabelCenters(*this->Labels);
  }
  const auto center = this->Centers->find(label->first);
  return center != this->Centers->end() ? std::make_optional(center->second) : std::nullopt;
}
} // namespace palpate
