#include "IslandNeighbour.h"

#include "MaskRuns.h"

#include "vtkImageData.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
using LabelPlace = std::pair<int, int>; // layer and value

// The second largest part; without voxels if there is one part only.
VoxelMask IslandOf(const VoxelMask& mask)
{
  VoxelMask island = mask;
  std::fill(island.Inside.begin(), island.Inside.end(), static_cast<unsigned char>(0));
  const RunSet runs = RunsOf(mask);
  const std::vector<int> parts = LabelRunComponents(runs, Neighborhood::FacesEdgesCorners);
  std::vector<long long> counts = ComponentVoxels(runs, parts);
  if (counts.size() > 1)
  {
    *std::max_element(counts.begin(), counts.end()) = 0;
    const auto second =
        static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
    SetRuns(
        runs, [&](std::size_t run) { return parts[run] == second; }, 1, island);
  }
  return island;
}

// Areas (mm^2) of the faces between voxels of a mask and those of other labels.
class FacesOfLabels
{
public:
  FacesOfLabels(const Segmentation& labels, const Segment& own) : Labels(labels), Own(own) {}

  std::map<LabelPlace, double> Around(const VoxelMask& mask)
  {
    std::array<int, 3> at{};
    for (std::size_t voxel = 0; voxel < mask.Inside.size(); ++voxel)
    {
      if (mask.Inside[voxel] != 0)
      {
        this->CountAt(at, mask);
      }
      for (std::size_t axis = 0; axis < 3 && ++at[axis] == mask.Size[axis]; ++axis)
      {
        at[axis] = 0;
      }
    }
    return std::move(this->Areas);
  }

private:
  // Voxels inside have neighbours in the box, which has a rim.
  void CountAt(const std::array<int, 3>& at, const VoxelMask& mask)
  {
    for (std::size_t face = 0; face < 6; ++face)
    {
      const std::size_t axis = face / 2;
      std::array<int, 3> next = at;
      next[axis] += face % 2 == 0 ? -1 : 1;
      if (mask.Inside[mask.Offset(next[0], next[1], next[2])] == 0)
      {
        const std::array<int, 3>& start = mask.StartIndex;
        this->Count({next[0] + start[0], next[1] + start[1], next[2] + start[2]},
                    mask.VoxelVolume() / mask.Spacing[axis]);
      }
    }
  }

  void Count(const std::array<int, 3>& voxel, double area)
  {
    for (std::size_t n = 0; n < this->Labels.Layers.size(); ++n)
    {
      vtkImageData* const layer = this->Labels.Layers[n];
      const int* const size = layer->GetDimensions();
      const bool isIn = voxel[0] >= 0 && voxel[1] >= 0 && voxel[2] >= 0 && voxel[0] < size[0] &&
                        voxel[1] < size[1] && voxel[2] < size[2];
      const LabelPlace label{static_cast<int>(n),
                             isIn ? static_cast<int>(layer->GetScalarComponentAsDouble(
                                        voxel[0], voxel[1], voxel[2], 0))
                                  : 0};
      if (label.second != 0 && label != LabelPlace{this->Own.Layer, this->Own.Value})
      {
        this->Areas[label] += area;
      }
    }
  }

  const Segmentation& Labels;
  const Segment& Own;
  std::map<LabelPlace, double> Areas;
};
} // namespace

const Segment* NeighbourOfIsland(const Segmentation& labels, const Segment& structure,
                                 const CheckedMask& mask)
{
  const std::map<LabelPlace, double> areas =
      FacesOfLabels(labels, structure).Around(IslandOf(mask.Voxels));
  const Segment* nearest = nullptr;
  double most = 0.0;
  for (const Segment& one : labels.Segments)
  {
    const auto found = areas.find({one.Layer, one.Value});
    if (found != areas.end() && found->second > most)
    {
      most = found->second;
      nearest = &one;
    }
  }
  return nearest;
}
} // namespace palpate
