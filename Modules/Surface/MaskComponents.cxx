#include "MaskComponents.h"

#include <cstdlib>
#include <numeric>

namespace palpate
{
namespace
{
enum class Neighbours
{
  Faces,
  FacesEdgesCorners
};

std::vector<std::array<int, 3>> Steps(Neighbours kind)
{
  std::vector<std::array<int, 3>> steps;
  for (int k = -1; k <= 1; ++k)
  {
    for (int j = -1; j <= 1; ++j)
    {
      for (int i = -1; i <= 1; ++i)
      {
        const int distance = std::abs(i) + std::abs(j) + std::abs(k);
        if (distance == 1 || (distance > 1 && kind == Neighbours::FacesEdgesCorners))
        {
          steps.push_back({i, j, k});
        }
      }
    }
  }
  return steps;
}

// Writes the number of its region, from 1, to `regions` for every voxel that has `value`, and
// returns the regions' sizes.
std::vector<long long> LabelRegions(const VoxelMask& mask, unsigned char value, Neighbours kind,
                                    std::vector<int>& regions)
{
  const std::vector<std::array<int, 3>> steps = Steps(kind);
  std::vector<long long> sizes;
  std::vector<std::array<int, 3>> stack;
  regions.assign(mask.Inside.size(), 0);
  const auto visit = [&](int i, int j, int k)
  {
    const std::size_t at = mask.Offset(i, j, k);
    if (mask.Inside[at] == value && regions[at] == 0)
    {
      regions[at] = static_cast<int>(sizes.size());
      ++sizes.back();
      stack.push_back({i, j, k});
    }
  };
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      for (int i = 0; i < mask.Size[0]; ++i)
      {
        const std::size_t at = mask.Offset(i, j, k);
        if (mask.Inside[at] != value || regions[at] != 0)
        {
          continue;
        }
        sizes.push_back(0);
        visit(i, j, k);
        while (!stack.empty())
        {
          const std::array<int, 3> from = stack.back();
          stack.pop_back();
          for (const std::array<int, 3>& step : steps)
          {
            const int ni = from[0] + step[0];
            const int nj = from[1] + step[1];
            const int nk = from[2] + step[2];
            if (ni >= 0 && nj >= 0 && nk >= 0 && ni < mask.Size[0] && nj < mask.Size[1] &&
                nk < mask.Size[2])
            {
              visit(ni, nj, nk);
            }
          }
        }
      }
    }
  }
  return sizes;
}
} // namespace

MaskComponents::MaskComponents(const VoxelMask& mask)
{
  const std::vector<long long> sizes = LabelRegions(mask, 1, Neighbours::Faces, this->Labels);
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&sizes](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  std::vector<int> rank(sizes.size() + 1, 0);
  for (std::size_t r = 0; r < order.size(); ++r)
  {
    rank[order[r] + 1] = static_cast<int>(r) + 1;
    this->Counts.push_back(sizes[order[r]]);
  }
  for (int& label : this->Labels)
  {
    label = rank[static_cast<std::size_t>(label)];
  }
}

void MaskComponents::Keep(int rank, VoxelMask& mask) const
{
  for (std::size_t at = 0; at < mask.Inside.size(); ++at)
  {
    mask.Inside[at] = this->Labels[at] == rank + 1 ? 1 : 0;
  }
}

MaskCavities FillCavities(VoxelMask& mask)
{
  std::vector<int> regions;
  const std::vector<long long> sizes =
      LabelRegions(mask, 0, Neighbours::FacesEdgesCorners, regions);
  // The scan starts at the empty border, so region 1 is the outside.
  MaskCavities cavities;
  cavities.Count = static_cast<int>(sizes.size()) - 1;
  cavities.Voxels = std::accumulate(sizes.begin() + 1, sizes.end(), 0LL);
  for (std::size_t at = 0; at < mask.Inside.size(); ++at)
  {
    if (regions[at] > 1)
    {
      mask.Inside[at] = 1;
    }
  }
  return cavities;
}
} // namespace palpate
