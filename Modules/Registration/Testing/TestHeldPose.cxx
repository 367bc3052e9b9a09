#include "HeldPose.h"

#include "HeldCases.h"

#include <gtest/gtest.h>

namespace palpate::held_pose_test
{
namespace
{
constexpr double Spring = 0.2; // N/mm

TEST(HeldPose, EnergyNeverRisesWhileTheHandRests)
{
  test::Random random(6);
  HeldFitSettings settings;
  settings.Points = 32;
  const HeldFit fit = test::EllipsoidFit(6, settings);
  for (int draw = 0; draw < 40; ++draw)
  {
    HeldPose pose(fit, Spring, test::RandomMove(random, 12.0, 0.5));
    pose.Move(test::RandomVector(random, 10.0));
    double before = pose.Energy();
    for (int step = 0; step < 100; ++step)
    {
      pose.Step();
      const double now = pose.Energy();
      ASSERT_LE(now, before + 1e-12) << draw;
      before = now;
    }
  }
}

// In the end the spring's force is that of the surfaces.
TEST(HeldPose, RestsWhereForcesBalance)
{
  const HeldFit fit = test::EllipsoidFit(10);
  HeldPose pose(fit, Spring, Eigen::Affine3d::Identity());
  pose.Move({0.0, 0.0, 3.0});
  for (int step = 0; step < 200 && pose.Step() > 1e-10; ++step)
  {
  }
  const Vector3 stretch = pose.Pose().translation() - pose.Asked().translation();
  EXPECT_LT((fit.At(pose.Pose()).Force - Spring * stretch).norm(), 1e-8);
  EXPECT_LT(pose.Pose().translation().z(), 2.5) << "it resists where it fits";
  EXPECT_GT(pose.Pose().translation().z(), 0.5);
}

TEST(HeldPose, FollowsTheHandWhereNothingIsNear)
{
  const HeldFit fit = test::EllipsoidFit(6);
  HeldPose pose(fit, Spring, Eigen::Affine3d(Eigen::Translation3d(100.0, 0.0, 0.0)));
  pose.Move({5.0, -4.0, 3.0});
  for (int step = 0; step < 100; ++step)
  {
    pose.Step();
  }
  EXPECT_LT((pose.Pose().translation() - Vector3(105.0, -4.0, 3.0)).norm(), 1e-9);
}

TEST(HeldPose, TurnKeepsThePivotAndTheStretch)
{
  test::Random random(7);
  const HeldFit fit = test::EllipsoidFit(6);
  HeldPose pose(fit, Spring, test::RandomMove(random, 5.0, 0.3));
  pose.Move({1.0, 2.0, 3.0});
  const Vector3 pivot = pose.Pose() * fit.Pivot();
  const Vector3 asked = pose.Asked() * fit.Pivot();
  const Eigen::Matrix3d before = pose.Pose().linear();
  const Vector3 rotation(0.2, -0.1, 0.3);
  pose.Turn(rotation);
  EXPECT_LT((pose.Pose() * fit.Pivot() - pivot).norm(), 1e-12);
  EXPECT_LT((pose.Asked() * fit.Pivot() - asked).norm(), 1e-12);
  EXPECT_LT((pose.Asked().linear() - pose.Pose().linear()).norm(), 1e-12);
  const Eigen::AngleAxisd made(Eigen::Matrix3d(pose.Pose().linear() * before.transpose()));
  EXPECT_LT((made.angle() * made.axis() - rotation).norm(), 1e-12);
}

TEST(PoseRamp, GoesFromOneToTheOtherWithoutAJump)
{
  test::Random random(8);
  const Eigen::Affine3d from = test::RandomMove(random, 10.0, 0.4);
  const Eigen::Affine3d to = test::RandomMove(random, 10.0, 0.4) * Eigen::Scaling(1.1);
  const Vector3 pivot(40.0, -20.0, 10.0);
  constexpr double Duration = 0.5;
  const PoseRamp ramp(from, to, pivot, Duration);
  EXPECT_LT((ramp.At(0.0).matrix() - from.matrix()).norm(), 1e-12);
  EXPECT_LT((ramp.At(Duration).matrix() - to.matrix()).norm(), 1e-12);
  EXPECT_LT((ramp.At(7.0).matrix() - to.matrix()).norm(), 1e-12);
  EXPECT_FALSE(ramp.IsOverAt(0.49));
  EXPECT_TRUE(ramp.IsOverAt(0.5));
  // No tick moves the pivot by more than half again the mean, and the first ones hardly.
  const double way = (to * pivot - from * pivot).norm();
  for (double time = 0.0; time < Duration; time += 0.001)
  {
    const double step = (ramp.At(time + 0.001) * pivot - ramp.At(time) * pivot).norm();
    EXPECT_LE(step, 1.5 * way * 0.001 / Duration + 1e-12);
  }
  EXPECT_LT((ramp.At(0.001) * pivot - from * pivot).norm(), 2e-5 * way);
}
} // namespace
} // namespace palpate::held_pose_test
