#include "SteeredPose.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace palpate::steered_pose_test
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double Period = 0.001; // s

SteeringInput Pushed(const Vector3& push)
{
  SteeringInput input;
  input.Push = push;
  return input;
}

/// A free hand, which is wherever it is led.
Vector3 AfterOneSecond(const SteeringInput& input, double distance, const Vector3& start)
{
  SteeredPose steered;
  steered.Begin(start);
  for (int n = 0; n < 1000; ++n)
  {
    steered.Advance(input, steered.Target(), distance, Period);
  }
  return steered.Target();
}

TEST(SteeredPose, FullDeflectionIsFullSpeed)
{
  const Vector3 start(-38.0, 0.0, 0.0);
  SteeringSettings settings;
  EXPECT_NEAR((AfterOneSecond(Pushed(Vector3::UnitX()), Infinite, start) - start).norm(),
              2.0 * settings.Reach - 2.0, 1e-9)
      << "80 mm/s would leave the reach";
  SteeredPose steered;
  steered.Begin(start);
  for (int n = 0; n < 500; ++n)
  {
    steered.Advance(Pushed(Vector3::UnitX()), steered.Target(), Infinite, Period);
  }
  EXPECT_NEAR((steered.Target() - start).x(), 0.5 * settings.FullSpeed, 1e-9);
}

TEST(SteeredPose, SmallDeflectionsAreFineOnes)
{
  const Vector3 quarter =
      AfterOneSecond(Pushed(0.25 * Vector3::UnitY()), Infinite, Vector3::Zero());
  const Vector3 half = AfterOneSecond(Pushed(0.5 * Vector3::UnitY()), Infinite, Vector3::Zero());
  EXPECT_GT(quarter.y(), 0.0);
  EXPECT_GT(half.y(), 2.2 * quarter.y());
  EXPECT_EQ(AfterOneSecond(Pushed(0.07 * Vector3::UnitY()), Infinite, Vector3::Zero()),
            Vector3::Zero());
}

TEST(SteeredPose, IsSlowNearASurface)
{
  const SteeringInput input = Pushed(-0.6 * Vector3::UnitZ());
  const double far = -AfterOneSecond(input, Infinite, Vector3::Zero()).z();
  EXPECT_NEAR(-AfterOneSecond(input, 0.0, Vector3::Zero()).z(), 0.25 * far, 1e-9);
  EXPECT_NEAR(-AfterOneSecond(input, 10.0, Vector3::Zero()).z(), 0.625 * far, 1e-9);
}

TEST(SteeredPose, HeldHandIsPushedByTheDeflection)
{
  for (const double deflection : {1.0, 0.5})
  {
    SteeredPose steered;
    const Vector3 held(1.0, 2.0, 3.0);
    steered.Begin(held);
    for (int n = 0; n < 3000; ++n)
    {
      steered.Advance(Pushed(deflection * Vector3::UnitX()), held, Infinite, Period);
    }
    const SteeringSettings settings;
    const double used = (deflection - settings.DeadZone) / (1.0 - settings.DeadZone);
    EXPECT_NEAR((steered.Target() - held).x(), used * settings.Lead, 1e-9);
    for (int n = 0; n < 500; ++n)
    {
      steered.Advance({}, held, Infinite, Period);
    }
    EXPECT_EQ(steered.Target(), held) << "a stick that is released pushes no more";
  }
}

TEST(SteeredPose, TurnsAboutTheAxisOfItsDeflection)
{
  SteeredPose steered;
  SteeringInput input;
  input.Turn = Vector3::UnitZ();
  for (int n = 0; n < 1000; ++n)
  {
    steered.Advance(input, Vector3::Zero(), Infinite, Period);
  }
  const Eigen::AngleAxisd turned(steered.Orientation());
  EXPECT_NEAR(turned.angle(), SteeringSettings().FullTurn, 1e-9);
  EXPECT_NEAR(turned.axis().z(), 1.0, 1e-12);
}

TEST(SteeredPose, StaysInReachAndUnitForAnyInput)
{
  std::mt19937 random(65);
  std::uniform_real_distribution<double> any(-1e3, 1e3);
  const double odd[] = {std::numeric_limits<double>::quiet_NaN(), Infinite, -Infinite, 1e308};
  SteeredPose steered;
  for (int n = 0; n < 20000; ++n)
  {
    SteeringInput input;
    input.Push = Vector3(any(random), any(random), any(random));
    input.Turn = Vector3(any(random), any(random), any(random));
    if (n % 7 == 0)
    {
      input.Push.X = odd[n % 4];
      input.Turn.Z = odd[(n / 4) % 4];
    }
    steered.Advance(input, Vector3::Random() * 40.0, any(random), 1e-3 * any(random));
    ASSERT_LE(steered.Target().lpNorm<Eigen::Infinity>(), SteeringSettings().Reach);
    ASSERT_NEAR(steered.Orientation().norm(), 1.0, 1e-12);
  }
}
} // namespace
} // namespace palpate::steered_pose_test
