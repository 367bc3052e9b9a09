#include "MessageOf.h"
#include "RandomShapes.h"
#include "SliceStack.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::slice_stack_test
{
namespace
{
using namespace palpate::test;

SlicePlane PlaneAt(double height, const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity())
{
  SlicePlane plane;
  plane.RowWorld = axes.col(0);
  plane.ColumnWorld = axes.col(1);
  plane.PositionWorld = Vector3(1, 2, 3) + height * axes.col(2);
  plane.Spacing = Vector3(0.5, 0.75, 0);
  plane.Columns = 10;
  plane.Rows = 20;
  return plane;
}

std::vector<SlicePlane> PlanesAt(const std::vector<double>& heights)
{
  std::vector<SlicePlane> planes;
  planes.reserve(heights.size());
  for (const double height : heights)
  {
    planes.push_back(PlaneAt(height));
  }
  return planes;
}

std::string Refusal(const std::vector<double>& heights, const SliceStackRules& rules)
{
  return MessageOf([&] { StackSlices("x", PlanesAt(heights), rules); });
}

TEST(SliceStack, StackIsIndependentOfOrderAndOrientation)
{
  Random random(11);
  for (int round = 0; round < 30; ++round)
  {
    const Eigen::Matrix3d axes =
        Eigen::AngleAxisd(round, RandomDirection(random)).toRotationMatrix();
    std::vector<SlicePlane> planes;
    planes.reserve(9);
    for (int slice = 0; slice < 9; ++slice)
    {
      planes.push_back(PlaneAt(2.5 * slice, axes));
    }
    std::shuffle(planes.begin(), planes.end(), random);
    const SliceStack stack = StackSlices("x", planes, {});
    // Coordinates of some 20 mm in double precision.
    EXPECT_LT((stack.Grid.OriginWorld - Vector3(1, 2, 3)).norm(), 1e-12);
    EXPECT_LT((stack.Grid.Direction - axes).norm(), 1e-12);
    EXPECT_NEAR(stack.Grid.Spacing[2], 2.5, 1e-12);
    for (std::size_t i = 0; i < planes.size(); ++i)
    {
      const Vector3 place =
          stack.Grid.OriginWorld + 2.5 * stack.SliceOfPlane[i] * stack.Grid.Direction.col(2);
      EXPECT_LT((place - planes[i].PositionWorld).norm(), 1e-12);
    }
  }
}

TEST(SliceStack, AcceptsRoundedPositions)
{
  const SliceStack stack = StackSlices("x", PlanesAt({0, 3.33, 6.67, 10.0}), {});
  EXPECT_NEAR(stack.Grid.Spacing[2], 10.0 / 3.0, 1e-12);
}

TEST(SliceStack, SparseStackFillsGaps)
{
  SliceStackRules rules;
  rules.Sparse = true;
  const SliceStack stack = StackSlices("x", PlanesAt({8, 2, 2, 0}), rules);
  EXPECT_EQ(stack.SliceOfPlane, (std::vector<int>{4, 1, 1, 0}));
  EXPECT_EQ(stack.Grid.Size[2], 5);
}

TEST(SliceStack, UsesStatedSpacingIfConsistent)
{
  SliceStackRules rules;
  rules.Sparse = true;
  rules.StatedStep = 1.0;
  EXPECT_EQ(StackSlices("x", PlanesAt({0, 4}), rules).Grid.Size[2], 5);
  rules.StatedStep = 3.0;
  EXPECT_EQ(StackSlices("x", PlanesAt({0, 4}), rules).Grid.Size[2], 2);
}

TEST(SliceStack, RejectsUnevenStacks)
{
  SliceStackRules sparse;
  sparse.Sparse = true;
  EXPECT_TRUE(Contains(Refusal({0, 1, 2.2, 3.2}, {}), "uneven gaps between its slices (1 to 1.2"));
  EXPECT_TRUE(Contains(Refusal({0, 2, 5}, sparse), "uneven gaps"));
  EXPECT_TRUE(Contains(Refusal({0, 1, 1, 2}, {}), "4 images in 3 positions"));
  EXPECT_TRUE(Contains(Refusal({0}, {}), "single slice"));
  EXPECT_TRUE(Contains(Refusal({0}, sparse), "does not state the distance between its slices"));
}

TEST(SliceStack, RejectsPlanesOfDifferentOrientation)
{
  std::vector<SlicePlane> planes = PlanesAt({0, 1});
  planes[1].RowWorld = Vector3::UnitY();
  planes[1].ColumnWorld = Vector3::UnitZ();
  EXPECT_TRUE(Contains(MessageOf([&] { StackSlices("x", planes, {}); }), "different orientation"));
}
} // namespace
} // namespace palpate::slice_stack_test
