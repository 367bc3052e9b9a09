#include "ImageGrid.h"
#include "MessageOf.h"
#include "RandomShapes.h"
#include "SliceStack.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::slice_stack_test
{
namespace
{
using namespace palpate::test;

StackedSlice PlaneAt(double height, const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity())
{
  StackedSlice plane;
  plane.RowWorld = axes.col(0);
  plane.ColumnWorld = axes.col(1);
  plane.PositionWorld = Vector3(1, 2, 3) + height * axes.col(2);
  plane.Spacing = Vector3(0.5, 0.75, 0);
  plane.Columns = 10;
  plane.Rows = 20;
  return plane;
}

std::vector<StackedSlice> PlanesAt(const std::vector<double>& heights)
{
  std::vector<StackedSlice> planes;
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
    std::vector<StackedSlice> planes;
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

// 0.625 mm as a header with one decimal has it: up to 8 % of the spacing.
TEST(SliceStack, PositionsRoundedByLessThanTenthOfVoxelAreMadeEven)
{
  std::vector<double> rounded;
  for (int slice = 0; slice < 80; ++slice)
  {
    rounded.push_back(std::round(0.625 * slice * 10.0) / 10.0);
  }
  const SliceStack stack = StackSlices("x", PlanesAt(rounded), {});
  EXPECT_EQ(stack.Grid.Size[2], 80);
  EXPECT_NEAR(stack.Grid.Spacing[2], 0.625, 1e-3);
  EXPECT_EQ(stack.Notes.size(), 1u);
  for (int slice = 0; slice < 80; ++slice)
  {
    const Vector3 place =
        stack.Grid.OriginWorld + stack.Grid.Spacing[2] * slice * stack.Grid.Direction.col(2);
    EXPECT_NEAR(place[2] - 3.0, 0.625 * slice, 0.0625) << slice;
  }
  SliceStackRules sparse;
  sparse.Sparse = true;
  rounded.erase(rounded.begin() + 20, rounded.begin() + 30);
  EXPECT_EQ(StackSlices("x", PlanesAt(rounded), sparse).Grid.Size[2], 80);
}

TEST(SliceStack, TiltedStackKeepsItsAxis)
{
  std::vector<StackedSlice> planes = PlanesAt({0, 3, 6, 9});
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    planes[i].PositionWorld[1] += 0.6 * static_cast<double>(i);
  }
  const SliceStack stack = StackSlices("x", planes, {});
  EXPECT_LT((stack.Grid.Direction.col(2) - Vector3(0, 0.2, 1).normalized()).norm(), 1e-12);
  EXPECT_TRUE(IsSheared(stack.Grid));
  EXPECT_TRUE(stack.Notes.empty());
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
  EXPECT_TRUE(Contains(Refusal({0, 1, 2.5, 3.5}, {}), "uneven gaps between its slices (1 to 1.5"));
  EXPECT_TRUE(Contains(Refusal({0, 2, 5}, sparse), "uneven gaps"));
  EXPECT_TRUE(Contains(Refusal({0, 1, 1, 2}, {}), "4 images in 3 positions"));
  EXPECT_TRUE(Contains(Refusal({0}, {}), "single slice"));
  EXPECT_TRUE(Contains(Refusal({0}, sparse), "does not state the distance between its slices"));
}

TEST(SliceStack, NamesSlicesAroundGap)
{
  std::vector<StackedSlice> planes = PlanesAt({0, 1, 2, 5, 6, 7});
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    planes[i].Name = "f" + std::to_string(i) + ".dcm";
  }
  const std::string refusal = MessageOf([&] { StackSlices("x", planes, {}); });
  EXPECT_TRUE(
      Contains(refusal, "about 2 slices missing between f2.dcm at S 5 mm and f3.dcm at S 8 mm"))
      << refusal;
  planes = PlanesAt({0, 1, 1, 2});
  planes[1].Name = "a.dcm";
  planes[2].Name = "b.dcm";
  EXPECT_TRUE(Contains(MessageOf([&] { StackSlices("x", planes, {}); }),
                       "such as a.dcm and b.dcm at S 4 mm"));
}

TEST(SliceStack, RejectsPlanesOfDifferentOrientation)
{
  std::vector<StackedSlice> planes = PlanesAt({0, 1});
  planes[1].RowWorld = Vector3::UnitY();
  planes[1].ColumnWorld = Vector3::UnitZ();
  EXPECT_TRUE(Contains(MessageOf([&] { StackSlices("x", planes, {}); }), "different orientation"));
}
} // namespace
} // namespace palpate::slice_stack_test
