#include "MaskComponents.h"

#include <algorithm>
#include <numeric>

namespace palpate
{
namespace
{
RunSet RunsOf(const VoxelMask& mask)
{
  RunSet runs;
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      const unsigned char* const row = mask.Inside.data() + mask.Offset(0, j, k);
      const unsigned char* const end = row + mask.Size[0];
      for (const unsigned char* first = std::find(row, end, 1); first != end;)
      {
        const unsigned char* const behind = std::find(first, end, 0);
        runs.Add({static_cast<int>(first - row), static_cast<int>(behind - row)}, j, k);
        first = std::find(behind, end, 1);
      }
    }
  }
  return runs;
}

// Puts the runs into the mask for which `isWanted` is true of their index.
template <typename Wanted>
void Fill(const RunSet& runs, const Wanted& isWanted, VoxelMask& mask)
{
  for (std::size_t row = 0; row < runs.Rows().size(); ++row)
  {
    unsigned char* const voxels =
        mask.Inside.data() + mask.Offset(0, runs.Rows()[row].Y, runs.Rows()[row].Z);
    for (std::size_t run = runs.Rows()[row].Start; run < runs.RowEnd(row); ++run)
    {
      if (isWanted(run))
      {
        std::fill(voxels + runs.Runs()[run].First, voxels + runs.Runs()[run].End, 1);
      }
    }
  }
}
} // namespace

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
  Fill(
      this->Runs, [&](std::size_t run) { return this->Ranks[run] == rank; }, mask);
}

MaskCavities FillCavities(VoxelMask& mask)
{
  const RunGaps gaps = FindCavities(RunsOf(mask));
  MaskCavities cavities;
  for (const long long voxels : gaps.CavityVoxels)
  {
    cavities.Count += voxels > 0 ? 1 : 0;
    cavities.Voxels += voxels;
  }
  Fill(
      gaps.Set,
      [&](std::size_t run)
      { return gaps.CavityVoxels[static_cast<std::size_t>(gaps.Components[run])] > 0; },
      mask);
  return cavities;
}
} // namespace palpate
