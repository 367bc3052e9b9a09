#include "CorrectedCases.h"
#include "CorrectedMask.h"
#include "MaskEdits.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::corrected_mask_test
{
namespace
{
using namespace palpate::test;

// A ball with a cavity and an island.
VoxelMask FlawedBall()
{
  return MaskWhere(
      [](const Vector3& point)
      {
        const Vector3 arm = point - CorrectedMiddle();
        const bool isHollow = (arm - Vector3(0.0, 6.0, 0.0)).norm() < 3.0;
        return (arm.norm() < 15.0 && !isHollow) || (arm - Vector3(22.0, 0.0, 0.0)).norm() < 3.0;
      });
}

SurfacePull PullTowards(const Vector3& direction, double by)
{
  return {CorrectedMiddle() + 15.0 * direction, by, {}, 6.0, 0.0};
}

std::vector<CorrectionStep> AllSteps()
{
  return {PullTowards(Vector3::UnitX(), 3.0),
          IslandRemoval{},
          PullTowards(Vector3::UnitY(), 4.0),
          PullTowards(-Vector3::UnitY(), -4.0),
          CavityFilling{},
          SurfaceSmoothing{1.5},
          PlaneCut{CorrectedMiddle() - Vector3(10.0, 0.0, 0.0), -Vector3::UnitX()},
          PullTowards(Vector3::UnitZ(), 2.0)};
}

// Voxels of the image, whatever the box.
std::vector<bool> VoxelsOf(const VoxelMask& mask)
{
  std::vector<bool> voxels;
  ForEachVoxel([&](const std::array<int, 3>& index, const Vector3&)
               { voxels.push_back(HasVoxel(mask, index)); });
  return voxels;
}

TEST(CorrectedMask, EachStepDoesItsPartAndIsUndone)
{
  CorrectedMask corrected(FlawedBall(), CorrectedFrame(), CorrectedImage);
  std::vector<std::vector<bool>> states{VoxelsOf(corrected.Mask())};
  for (const CorrectionStep& step : AllSteps())
  {
    const Status status = corrected.Apply(step);
    ASSERT_TRUE(status.IsOk()) << status.Message();
    states.push_back(VoxelsOf(corrected.Mask()));
    EXPECT_NE(states.back(), states[states.size() - 2]);
  }
  EXPECT_TRUE(HasVoxel(corrected.Mask(), {32, 48, 16}));  // pulled
  EXPECT_TRUE(HasVoxel(corrected.Mask(), {32, 37, 16}));  // filled
  EXPECT_FALSE(HasVoxel(corrected.Mask(), {54, 31, 16})); // the island
  EXPECT_FALSE(HasVoxel(corrected.Mask(), {21, 31, 16})); // cut
  for (std::size_t n = states.size() - 1; n > 0; --n)
  {
    ASSERT_TRUE(corrected.Undo());
    EXPECT_EQ(VoxelsOf(corrected.Mask()), states[n - 1]) << n;
  }
  EXPECT_FALSE(corrected.Undo());
}

TEST(CorrectedMask, IsAFunctionOfStartAndList)
{
  CorrectedMask one(FlawedBall(), CorrectedFrame(), CorrectedImage);
  CorrectedMask other(FlawedBall(), CorrectedFrame(), CorrectedImage);
  for (const CorrectionStep& step : AllSteps())
  {
    ASSERT_TRUE(one.Apply(step).IsOk());
    one.Mask();
    ASSERT_TRUE(other.Apply(PullTowards(Vector3::UnitZ(), 5.0)).IsOk());
    other.Mask();
    other.Undo();
    ASSERT_TRUE(other.Apply(step).IsOk());
  }
  EXPECT_EQ(VoxelsOf(one.Mask()), VoxelsOf(other.Mask()));
  EXPECT_EQ(other.Steps().size(), AllSteps().size());
}

TEST(CorrectedMask, RefusesWithoutAnEffect)
{
  CorrectedMask corrected(FlawedBall(), CorrectedFrame(), CorrectedImage);
  const std::vector<bool> before = VoxelsOf(corrected.Mask());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const CorrectionStep& step : std::vector<CorrectionStep>{
           PullTowards(Vector3::UnitX(), nan), SurfaceSmoothing{nan}, SurfaceSmoothing{0.0},
           SurfaceSmoothing{21.0}, PlaneCut{Vector3::Zero(), Vector3::Zero()},
           PlaneCut{Vector3(nan, 0.0, 0.0), Vector3::UnitX()},
           PlaneCut{CorrectedMiddle() - Vector3(90.0, 0.0, 0.0), Vector3::UnitX()}})
  {
    EXPECT_FALSE(corrected.Apply(step).IsOk());
  }
  EXPECT_EQ(VoxelsOf(corrected.Mask()), before);
  EXPECT_TRUE(corrected.Steps().empty());
  EXPECT_FALSE(CorrectedMask().Apply(PullTowards(Vector3::UnitX(), 1.0)).IsOk());
}

TEST(CorrectedMask, EditsAreBounded)
{
  CorrectedMask corrected(BallMask(4.0), CorrectedFrame(), CorrectedImage);
  for (std::size_t n = 0; n < CorrectedMask::MostEdits; ++n)
  {
    ASSERT_TRUE(corrected.Apply(IslandRemoval{}).IsOk());
  }
  EXPECT_FALSE(corrected.Apply(IslandRemoval{}).IsOk());
}
} // namespace
} // namespace palpate::corrected_mask_test
