#include "SegmentCompletion.h"

#include "DecimalText.h"
#include "LabelValues.h"
#include "Refusal.h"
#include "SegmentColor.h"

#include "vtkPointData.h"

#include <algorithm>
#include <map>
#include <set>

namespace palpate
{
namespace
{
using LayerCounts = std::vector<std::map<int, vtkIdType>>;

bool IsPresent(const LayerCounts& counts, const Segment& segment)
{
  return segment.Layer >= 0 && segment.Layer < static_cast<int>(counts.size()) &&
         counts[static_cast<std::size_t>(segment.Layer)].count(segment.Value) > 0;
}

void AddUndescribed(const LayerCounts& counts, std::vector<Segment>& segments)
{
  std::set<std::pair<int, int>> described;
  for (const Segment& segment : segments)
  {
    described.emplace(segment.Layer, segment.Value);
  }
  for (std::size_t layer = 0; layer < counts.size(); ++layer)
  {
    for (const auto& [value, voxels] : counts[layer])
    {
      Segment segment;
      segment.Label = value;
      segment.Value = value;
      segment.Layer = static_cast<int>(layer);
      segment.Color = DefaultSegmentColor(value);
      if (described.count({segment.Layer, segment.Value}) == 0)
      {
        segments.push_back(segment);
      }
    }
  }
}

void MakeLabelsUnique(std::vector<Segment>& segments)
{
  std::set<int> labels;
  for (const Segment& segment : segments)
  {
    labels.insert(segment.Label);
  }
  if (labels.size() < segments.size())
  {
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      segments[i].Label = static_cast<int>(i + 1);
    }
  }
}

void DropEmpty(const LayerCounts& counts, Segmentation& segmentation)
{
  std::vector<Segment> present;
  std::set<std::pair<int, int>> taken;
  for (const Segment& segment : segmentation.Segments)
  {
    if (IsPresent(counts, segment) && taken.emplace(segment.Layer, segment.Value).second)
    {
      present.push_back(segment);
    }
    else
    {
      segmentation.Notes.push_back("Segment " + std::to_string(segment.Label) +
                                   (segment.Name.empty() ? "" : " '" + segment.Name + "'") +
                                   " is empty and was left out.");
    }
  }
  segmentation.Segments = present;
}
// Larger than any body, as if the header's unit were wrong.
void NoteImpossibleVolume(const LayerCounts& counts, Segmentation& segmentation)
{
  constexpr double LargestMilliliters = 1e6;
  constexpr double CubicMillimetersPerMilliliter = 1e3;
  double largest = 0.0;
  for (std::size_t layer = 0; layer < counts.size(); ++layer)
  {
    const double* spacing = segmentation.Layers[layer]->GetSpacing();
    const double voxel = spacing[0] * spacing[1] * spacing[2] / CubicMillimetersPerMilliliter;
    for (const auto& [value, voxels] : counts[layer])
    {
      largest = std::max(largest, voxel * static_cast<double>(voxels));
    }
  }
  if (largest > LargestMilliliters)
  {
    segmentation.Notes.push_back("A structure of " + SignificantText(largest, 3) +
                                 " ml is larger than a body; check the unit of the header (mm).");
  }
}
} // namespace

void CompleteSegments(Segmentation& segmentation)
{
  LayerCounts counts;
  for (const auto& layer : segmentation.Layers)
  {
    counts.push_back(CountLabels(layer->GetPointData()->GetScalars()));
  }
  AddUndescribed(counts, segmentation.Segments);
  MakeLabelsUnique(segmentation.Segments);
  DropEmpty(counts, segmentation);
  NoteImpossibleVolume(counts, segmentation);
  if (segmentation.Segments.empty())
  {
    Refuse(segmentation.Source, "has no labelled voxels (the mask is empty)",
           "check that it is the right file and was exported with its labels");
  }
  std::sort(segmentation.Segments.begin(), segmentation.Segments.end(),
            [](const Segment& a, const Segment& b) { return a.Label < b.Label; });
}
} // namespace palpate
