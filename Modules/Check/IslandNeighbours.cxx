#include "IslandNeighbours.h"

#include "MaskRuns.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
using Index = std::array<int, 3>; // of the image

struct Island
{
  std::size_t Structure;
  std::vector<Index> Voxels;
  Index First; ///< of the box of its neighbours
  Index Last;
  double MostArea = 0.0; ///< mm^2
};

MaskStatistic* PartOf(CheckedOrgan& organ)
{
  MaskStatistics& all = organ.Measured.Statistics;
  const auto found = std::find_if(all.begin(), all.end(),
                                  [](const MaskStatistic& one) { return one.Key == "part"; });
  return found != all.end() ? &*found : nullptr;
}

// The voxels of the second largest part; none if there is one part only.
std::vector<Index> IslandVoxels(VoxelMask mask)
{
  const RunSet runs = RunsOf(mask);
  const std::vector<int> parts = LabelRunComponents(runs, Neighborhood::FacesEdgesCorners);
  std::vector<long long> counts = ComponentVoxels(runs, parts);
  if (counts.size() < 2)
  {
    return {};
  }
  *std::max_element(counts.begin(), counts.end()) = 0;
  const auto second =
      static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  std::fill(mask.Inside.begin(), mask.Inside.end(), static_cast<unsigned char>(0));
  SetRuns(
      runs, [&](std::size_t run) { return parts[run] == second; }, 1, mask);
  std::vector<Index> voxels;
  Index at{};
  for (const unsigned char isInside : mask.Inside)
  {
    if (isInside != 0)
    {
      voxels.push_back(
          {at[0] + mask.StartIndex[0], at[1] + mask.StartIndex[1], at[2] + mask.StartIndex[2]});
    }
    for (std::size_t axis = 0; axis < 3 && ++at[axis] == mask.Size[axis]; ++axis)
    {
      at[axis] = 0;
    }
  }
  return voxels;
}

std::vector<Island> IslandsOf(const CaseMasks& masks, CheckedCase& patient)
{
  std::vector<Island> islands;
  for (std::size_t n = 0; n < masks.Structures.size(); ++n)
  {
    MaskStatistic* const part = PartOf(patient.Organs[n]);
    if (part == nullptr || !(part->Value > 0.0))
    {
      continue;
    }
    part->Other = std::string();
    Island island{n, IslandVoxels(masks.MaskOf(n).Voxels), {}, {}};
    if (island.Voxels.empty())
    {
      continue;
    }
    island.First = island.Last = island.Voxels.front();
    for (const Index& voxel : island.Voxels)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        island.First[axis] = std::min(island.First[axis], voxel[axis] - 1);
        island.Last[axis] = std::max(island.Last[axis], voxel[axis] + 1);
      }
    }
    islands.push_back(std::move(island));
  }
  return islands;
}

bool IsNear(const Island& island, const VoxelMask& mask)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (island.Last[axis] < mask.StartIndex[axis] ||
        island.First[axis] >= mask.StartIndex[axis] + mask.Size[axis])
    {
      return false;
    }
  }
  return true;
}

bool IsInside(const VoxelMask& mask, Index voxel)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    voxel[axis] -= mask.StartIndex[axis];
    if (voxel[axis] < 0 || voxel[axis] >= mask.Size[axis])
    {
      return false;
    }
  }
  return mask.Inside[mask.Offset(voxel[0], voxel[1], voxel[2])] != 0;
}

// Of the faces that an island shares with a mask, mm^2.
double SharedArea(const Island& island, const VoxelMask& mask)
{
  double area = 0.0;
  for (const Index& voxel : island.Voxels)
  {
    for (std::size_t face = 0; face < 6; ++face)
    {
      const std::size_t axis = face / 2;
      Index next = voxel;
      next[axis] += face % 2 == 0 ? -1 : 1;
      area += IsInside(mask, next) ? mask.VoxelVolume() / mask.Spacing[axis] : 0.0;
    }
  }
  return area;
}
} // namespace

void NameIslandNeighbours(const CaseMasks& masks, CheckedCase& patient)
{
  std::vector<Island> islands = IslandsOf(masks, patient);
  for (std::size_t n = 0; n < masks.Structures.size() && !islands.empty(); ++n)
  {
    const VoxelMask mask = masks.MaskOf(n).Voxels;
    for (Island& island : islands)
    {
      if (island.Structure == n || !IsNear(island, mask))
      {
        continue;
      }
      const double area = SharedArea(island, mask);
      if (area > island.MostArea)
      {
        island.MostArea = area;
        PartOf(patient.Organs[island.Structure])->Other = patient.Organs[n].Name;
      }
    }
  }
}
} // namespace palpate
