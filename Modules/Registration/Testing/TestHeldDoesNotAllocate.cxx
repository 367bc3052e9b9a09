#include "AllocationCounter.h"
#include "HeldCases.h"
#include "HeldPose.h"

#include <gtest/gtest.h>

namespace palpate::held_does_not_allocate_test
{
namespace
{
TEST(HeldDoesNotAllocate, Ticks)
{
  const HeldFit fit = test::EllipsoidFit(8);
  HeldPose pose(fit, 0.2, Eigen::Affine3d(Eigen::Translation3d(3.0, 0.0, 0.0)));
  const PoseRamp ramp(pose.Pose(), Eigen::Affine3d::Identity(), fit.Pivot(), 0.5);
  const std::size_t before = test::AllocationCount();
  double sum = 0.0;
  for (int tick = 0; tick < 100; ++tick)
  {
    pose.Move({0.01, -0.02, 0.0});
    pose.Turn({0.001, 0.0, 0.0});
    sum += pose.Step() + fit.At(ramp.At(0.005 * tick)).Energy;
  }
  EXPECT_EQ(test::AllocationCount(), before);
  EXPECT_GT(sum, 0.0);
}
} // namespace
} // namespace palpate::held_does_not_allocate_test
