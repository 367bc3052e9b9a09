#include "CorrectedCases.h"
#include "MaskEdits.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::mask_edits_test
{
namespace
{
using namespace palpate::test;

TEST(MaskEdits, IslandsAreTheSmallerParts)
{
  VoxelMask mask = MaskWhere(
      [](const Vector3& point)
      {
        const Vector3 arm = point - CorrectedMiddle();
        return arm.norm() < 10.0 || (arm - Vector3(20.0, 0.0, 0.0)).norm() < 3.0;
      });
  const VoxelMask ball = BallMask(10.0);
  const long long islands = mask.Count() - ball.Count();
  ASSERT_GT(islands, 0);
  EXPECT_EQ(RemoveIslands(mask), islands);
  EXPECT_EQ(mask.Inside, ball.Inside);
  EXPECT_EQ(RemoveIslands(mask), 0);
  EXPECT_EQ(mask.Inside, ball.Inside);
}

TEST(MaskEdits, SmoothingRemovesBristlesAndKeepsTheSize)
{
  const auto bristled = [](const Vector3& point)
  {
    const Vector3 arm = point - CorrectedMiddle();
    return arm.norm() < 15.0 ||
           (arm.norm() < 21.0 && std::abs(arm[1]) < 0.6 && arm[0] > 0.0 && std::abs(arm[2]) < 0.6);
  };
  VoxelMask mask = MaskWhere(bristled);
  const long long before = mask.Count();
  ASSERT_TRUE(HasVoxel(mask, {50, 31, 16}));
  SmoothMask(2.0, mask);
  EXPECT_FALSE(HasVoxel(mask, {50, 31, 16}));
  EXPECT_NEAR(static_cast<double>(mask.Count()), static_cast<double>(before), 60.0); // equal values
  int wrong = 0;
  ForEachVoxel(
      [&](const std::array<int, 3>& index, const Vector3& point)
      {
        const double excess = (point - CorrectedMiddle()).norm() - 15.0;
        wrong += std::abs(excess) > 1.0 && HasVoxel(mask, index) != (excess < 0.0) ? 1 : 0;
      });
  EXPECT_EQ(wrong, 0);
}

TEST(MaskEdits, ACutRemovesOneSideOfItsPlane)
{
  VoxelMask mask = BallMask(12.0);
  const VoxelMask before = mask;
  const Vector3 normal(1.0, 2.0, -0.5);
  const Vector3 point = CorrectedMiddle() + Vector3(3.0, 0.0, 0.0);
  CutMask(point, normal, CorrectedFrame(), mask);
  ForEachVoxel(
      [&](const std::array<int, 3>& index, const Vector3& at) {
        EXPECT_EQ(HasVoxel(mask, index),
                  HasVoxel(before, index) && (at - point).dot(normal) <= 0.0);
      });
}
} // namespace
} // namespace palpate::mask_edits_test
