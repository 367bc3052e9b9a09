#include "LabelOverlaps.h"

#include "Units.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr double Nested = 0.9;
constexpr vtkIdType Block = 1 << 16; // voxels

void CopyValues(vtkImageData* layer, vtkIdType first, std::vector<int>& values)
{
  vtkDataArray* const scalars = layer->GetPointData()->GetScalars();
  const auto copy = [&](const auto* voxels)
  {
    std::transform(voxels + first, voxels + first + static_cast<vtkIdType>(values.size()),
                   values.begin(), [](auto voxel) { return static_cast<int>(voxel); });
  };
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(copy(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0))));
  default:
    break;
  }
}

using LabelPair = std::pair<std::pair<int, int>, std::pair<int, int>>; // layer and value of each

// Voxels that two labels share.
std::map<LabelPair, long long> SharedVoxels(const Segmentation& labels)
{
  std::map<LabelPair, long long> shared;
  const vtkIdType voxels = labels.Layers.front()->GetNumberOfPoints();
  std::vector<std::vector<int>> values(labels.Layers.size());
  for (vtkIdType first = 0; first < voxels; first += Block)
  {
    const vtkIdType count = std::min(Block, voxels - first);
    for (std::size_t layer = 0; layer < values.size(); ++layer)
    {
      values[layer].assign(static_cast<std::size_t>(count), 0);
      CopyValues(labels.Layers[layer], first, values[layer]);
    }
    for (std::size_t a = 0; a < values.size(); ++a)
    {
      for (std::size_t b = a + 1; b < values.size(); ++b)
      {
        for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n)
        {
          if (values[a][n] != 0 && values[b][n] != 0)
          {
            ++shared[{{static_cast<int>(a), values[a][n]}, {static_cast<int>(b), values[b][n]}}];
          }
        }
      }
    }
  }
  return shared;
}

MaskStatistic& OverlapOf(CheckedOrgan& organ)
{
  MaskStatistics& all = organ.Measured.Statistics;
  const auto found = std::find_if(all.begin(), all.end(),
                                  [](const MaskStatistic& one) { return one.Key == "overlap"; });
  if (found != all.end())
  {
    return *found;
  }
  all.push_back({"overlap", 0.0, organ.Measured.Centroid, 0.0});
  return all.back();
}
} // namespace

void AddOverlaps(const Segmentation& labels, CheckedCase& patient)
{
  if (labels.Layers.size() < 2)
  {
    return;
  }
  std::map<std::pair<int, int>, CheckedOrgan*> organs;
  for (std::size_t n = 0; n < labels.Segments.size(); ++n)
  {
    organs[{labels.Segments[n].Layer, labels.Segments[n].Value}] = &patient.Organs[n];
    OverlapOf(patient.Organs[n]);
  }
  const double* const spacing = labels.Layers.front()->GetSpacing();
  for (const auto& [pair, voxels] : SharedVoxels(labels))
  {
    const auto one = organs.find(pair.first);
    const auto other = organs.find(pair.second);
    if (one == organs.end() || other == organs.end())
    {
      continue;
    }
    const double volume = static_cast<double>(voxels) * spacing[0] * spacing[1] * spacing[2];
    const double least =
        CubicMillimetersPerMilliliter *
        std::min(one->second->Measured.Milliliters, other->second->Measured.Milliliters);
    for (const auto& [organ, with] :
         {std::pair(one->second, other->second), std::pair(other->second, one->second)})
    {
      MaskStatistic& overlap = OverlapOf(*organ);
      const double share = volume / least;
      if (share <= Nested && share > overlap.Value)
      {
        overlap.Value = share;
        overlap.Amount = volume;
        overlap.Other = with->Name;
      }
    }
  }
}
} // namespace palpate
