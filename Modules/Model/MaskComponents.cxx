#include "MaskComponents.h"

#include "MaskRuns.h"

#include <algorithm>
#include <numeric>

namespace palpate
{
MaskComponents::MaskComponents(const VoxelMask& mask)
    : Runs(RunsOf(mask)), Ranks(LabelRunComponents(this->Runs, Neighborhood::Faces))
{
  const std::vector<long long> sizes = ComponentVoxels(this->Runs, this->Ranks);
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&sizes](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  std::vector<int> rank(sizes.size(), 0);
  for (std::size_t r = 0; r < order.size(); ++r)
  {
    rank[order[r]] = static_cast<int>(r);
    this->Counts.push_back(sizes[order[r]]);
  }
  for (int& component : this->Ranks)
  {
    component = rank[static_cast<std::size_t>(component)];
  }
}

void MaskComponents::Keep(int rank, VoxelMask& mask) const
{
  std::fill(mask.Inside.begin(), mask.Inside.end(), 0);
  SetRuns(
      this->Runs, [&](std::size_t run) { return this->Ranks[run] == rank; }, 1, mask);
}

MaskCavities FillCavities(VoxelMask& mask)
{
  const RunGaps gaps = FindCavities(RunsOf(mask));
  MaskCavities cavities;
  for (const long long voxels : gaps.CavityVoxels)
  {
    cavities.Count += voxels > 0 ? 1 : 0;
    cavities.Voxels += voxels;
    cavities.LargestVoxels = std::max<long long>(cavities.LargestVoxels, voxels);
  }
  SetRuns(
      gaps.Set,
      [&](std::size_t run)
      { return gaps.CavityVoxels[static_cast<std::size_t>(gaps.Components[run])] > 0; },
      1, mask);
  return cavities;
}
} // namespace palpate
