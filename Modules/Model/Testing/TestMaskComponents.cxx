#include "MaskComponents.h"

#include <gtest/gtest.h>

namespace palpate::mask_components_test
{
namespace
{
palpate::VoxelMask EmptyMask(int side)
{
  palpate::VoxelMask mask;
  mask.Size = {side, side, side};
  mask.Spacing = {1.0, 1.0, 1.0};
  mask.Inside.assign(static_cast<std::size_t>(side) * side * side, 0);
  return mask;
}

void FillBox(palpate::VoxelMask& mask, int from, int to)
{
  for (int k = from; k <= to; ++k)
  {
    for (int j = from; j <= to; ++j)
    {
      for (int i = from; i <= to; ++i)
      {
        mask.Inside[mask.Offset(i, j, k)] = 1;
      }
    }
  }
}

TEST(MaskComponents, AreSortedByDescendingSize)
{
  palpate::VoxelMask mask = EmptyMask(12);
  mask.Inside[mask.Offset(1, 1, 1)] = 1;
  FillBox(mask, 5, 8);
  mask.Inside[mask.Offset(10, 10, 10)] = 1;
  mask.Inside[mask.Offset(10, 10, 9)] = 1;
  EXPECT_EQ(palpate::MaskComponents(mask).VoxelCounts(), (std::vector<long long>{64, 2, 1}));
}

TEST(MaskComponents, SharedEdgeDoesNotConnect)
{
  palpate::VoxelMask mask = EmptyMask(4);
  mask.Inside[mask.Offset(1, 1, 1)] = 1;
  mask.Inside[mask.Offset(2, 2, 1)] = 1;
  EXPECT_EQ(palpate::MaskComponents(mask).VoxelCounts().size(), 2U);
}

TEST(MaskComponents, KeepLeavesRequestedComponent)
{
  palpate::VoxelMask mask = EmptyMask(12);
  FillBox(mask, 5, 8);
  mask.Inside[mask.Offset(1, 1, 1)] = 1;
  palpate::MaskComponents(mask).Keep(1, mask);
  EXPECT_EQ(mask.Count(), 1);
  EXPECT_EQ(mask.Inside[mask.Offset(1, 1, 1)], 1);
}

TEST(FillCavities, FillsAndCountsEnclosedRegions)
{
  palpate::VoxelMask mask = EmptyMask(12);
  FillBox(mask, 2, 9);
  mask.Inside[mask.Offset(4, 4, 4)] = 0;
  mask.Inside[mask.Offset(7, 7, 7)] = 0;
  mask.Inside[mask.Offset(7, 7, 6)] = 0;
  const palpate::MaskCavities cavities = palpate::FillCavities(mask);
  EXPECT_EQ(cavities.Count, 2);
  EXPECT_EQ(cavities.Voxels, 3);
  EXPECT_EQ(mask.Count(), 512);
}

TEST(FillCavities, LeavesPitWithDiagonalOpening)
{
  palpate::VoxelMask mask = EmptyMask(8);
  FillBox(mask, 2, 5);
  mask.Inside[mask.Offset(3, 3, 3)] = 0;
  mask.Inside[mask.Offset(2, 2, 2)] = 0;
  EXPECT_EQ(palpate::FillCavities(mask).Count, 0);
}
} // namespace
} // namespace palpate::mask_components_test
