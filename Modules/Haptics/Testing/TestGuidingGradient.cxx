#include "GuidingGradient.h"

#include "FeltCases.h"
#include "RandomOrientation.h"
#include "StiffnessAdvice.h"

#include <cmath>

namespace palpate::guiding_gradient_test
{
namespace
{
constexpr int Size = 41; // voxels of 1 mm

// A bright ball of 6 mm with a soft border, from 0 to 1000.
double Blob(const Vector3& place)
{
  return 1000.0 / (1.0 + std::exp(1.2 * (place.norm() - 6.0)));
}

// Bright up to the image's border.
double Waves(const Vector3& place)
{
  return 100.0 + 260.0 * std::sin(0.4 * place[0] + 0.2 * place[2]) * std::cos(0.3 * place[1]);
}

std::shared_ptr<const ScalarField> FieldOf(double (*value)(const Vector3&),
                                           const Matrix3& turn = Matrix3::Identity())
{
  return test::FeltField(test::FeltGrid(Size, turn), value, FieldInterpolation::TricubicBSpline);
}

GuidingSettings SettingsOf(double from, double to, double energy, double largest)
{
  GuidingSettings settings;
  settings.FromIntensity = from;
  settings.ToIntensity = to;
  settings.Energy = energy;
  settings.LargestForce = largest;
  return settings;
}

std::shared_ptr<const GuidingGradient> GradientOf(const std::shared_ptr<const ScalarField>& field,
                                                  const GuidingSettings& settings)
{
  std::shared_ptr<const GuidingGradient> gradient;
  const Status status = GuidingGradient::Make(field, 0, settings, gradient);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return gradient;
}

// A wall far below, which is never touched, carries the effect.
TouchScene FreeSpaceWith(std::shared_ptr<const ForceEffect> effect)
{
  TouchScene scene = test::WallScene(-30.0, {0.5, 0.0});
  scene.Structures[0].Effects = {std::move(effect)};
  return scene;
}

TEST(GuidingGradient, LeadsFromTheFirstIntensityToTheSecond)
{
  const auto field = FieldOf(Blob);
  const auto up = GradientOf(field, SettingsOf(0.0, 1000.0, 0.5, 1.0));
  const auto down = GradientOf(field, SettingsOf(1000.0, 0.0, 0.5, 1.0));
  test::Random random(821);
  for (int n = 0; n < 1000; ++n)
  {
    const Vector3 out = test::RandomDirection(random);
    EXPECT_LT(up->ForceWorld(6.0 * out).dot(out), -0.05);
    EXPECT_GT(down->ForceWorld(6.0 * out).dot(out), 0.05);
  }
}

// 1.5 E / (difference of intensities) per unit/mm, in a slope of 20 units/mm, up to single
// precision of the spline's coefficients.
TEST(GuidingGradient, HasTheStatedForcePerUnitAndMillimetreHalfWay)
{
  const auto ramp = [](const Vector3& place) { return 20.0 * place[0]; };
  const auto field =
      test::FeltField(test::FeltGrid(Size), ramp, FieldInterpolation::TricubicBSpline);
  const auto gradient = GradientOf(field, SettingsOf(-80.0, 80.0, 1.0, 2.0));
  EXPECT_EQ(gradient->Energy(), 1.0);
  const Vector3 expected(1.5 * 1.0 / 160.0 * 20.0, 0.0, 0.0);
  EXPECT_NEAR((gradient->ForceWorld({0.0, 1.0, 2.0}) - expected).norm(), 0.0, 1e-5);
  EXPECT_NEAR(gradient->PotentialAt({5.0, 1.0, 2.0}) - gradient->PotentialAt({-5.0, 1.0, 2.0}),
              -1.0, 1e-6);
}

TEST(GuidingGradient, IsTheNegativeSlopeOfItsPotential)
{
  test::Random random(822);
  const auto gradient =
      GradientOf(FieldOf(Waves, test::RandomOrientation(random)), SettingsOf(-100, 300, 0.8, 1.0));
  for (int n = 0; n < 2000; ++n)
  {
    const Vector3 place = 18.0 * test::RandomDirection(random);
    const Vector3 along = test::RandomDirection(random);
    constexpr double Step = 1e-4;
    const double slope = (gradient->PotentialAt(place + Step * along) -
                          gradient->PotentialAt(place - Step * along)) /
                         (2.0 * Step);
    EXPECT_NEAR(gradient->ForceWorld(place).dot(along), -slope, 1e-5);
  }
}

// Also beyond the image, and with a frame that turns and magnifies.
TEST(GuidingGradient, ClosedPathsDoNoWork)
{
  test::Random random(823);
  const Matrix3 turn = test::RandomOrientation(random);
  TouchScene scene =
      FreeSpaceWith(GradientOf(FieldOf(Waves, turn), SettingsOf(-100.0, 300.0, 0.8, 0.5)));
  scene.Frame = DeviceFrame(test::RandomOrientation(random), 1.4, Vector3::Zero());
  test::ClosedPath hand(scene);
  double largest = 0.0;
  for (int path = 0; path < 6; ++path)
  {
    const auto around = [path](double turned)
    {
      const double angle = 2.0 * M_PI * turned;
      return Vector3((3.0 + 4.0 * path) * std::sin(angle), 5.0 * std::cos(angle),
                     4.0 * std::cos(2.0 * angle + path));
    };
    EXPECT_NEAR(hand.FieldAlong(around, 50'000, largest), 0.0, 1e-6) << path; // N mm
  }
  EXPECT_GT(largest, 0.2);
}

TEST(GuidingGradient, IsNowhereAboveItsLargestForce)
{
  test::Random random(824);
  std::uniform_real_distribution<double> coordinate(-22.0, 22.0);
  for (const auto value : {Blob, Waves})
  {
    const auto gradient = GradientOf(FieldOf(value), SettingsOf(0.0, 250.0, 1e6, 0.3));
    double largest = 0.0;
    for (int n = 0; n < 100'000; ++n)
    {
      const Vector3 place(coordinate(random), coordinate(random), coordinate(random));
      largest = std::max(largest, gradient->ForceWorld(place).norm());
    }
    // By the potential, not by cutting it off.
    EXPECT_LT(largest, 0.3);
    EXPECT_GT(largest, 0.2);
  }
}

TEST(GuidingGradient, IsZeroOutsideAndHasNoSteps)
{
  const auto gradient = GradientOf(FieldOf(Waves), SettingsOf(-100.0, 300.0, 0.8, 0.5));
  for (const Vector3& place :
       {Vector3(20.0, 0.0, 0.0), Vector3(0.0, -20.0, 3.0), Vector3(20.001, 1.0, 1.0),
        Vector3(0.0, 0.0, 1e300), Vector3(test::NotANumber, 0.0, 0.0)})
  {
    EXPECT_EQ(gradient->ForceWorld(place), Vector3::Zero());
  }
  constexpr double Step = 1e-3;
  Vector3 before = Vector3::Zero();
  double largest = 0.0;
  for (int n = 0; n <= 60'000; ++n)
  {
    const Vector3 now = gradient->ForceWorld({-30.0 + Step * n, 1.3, -2.1});
    EXPECT_LE((now - before).norm(), 2.0 * gradient->Stiffness() * Step);
    largest = std::max(largest, now.norm());
    before = now;
  }
  EXPECT_GT(largest, 0.1);
}

TEST(GuidingGradient, IsZeroWhereTheImageIsConstant)
{
  const auto constant = test::FeltField(
      test::FeltGrid(Size), [](const Vector3&) { return 40.0; },
      FieldInterpolation::TricubicBSpline);
  const auto gradient = GradientOf(constant, SettingsOf(40.0, 100.0, 1.0, 0.5));
  test::Random random(825);
  for (int n = 0; n < 1000; ++n)
  {
    EXPECT_NEAR(gradient->ForceWorld(20.0 * test::RandomDirection(random)).norm(), 0.0, 1e-9);
  }
}

TEST(GuidingGradient, RejectsInvalidSettings)
{
  const auto field = FieldOf(Blob);
  std::shared_ptr<const GuidingGradient> gradient;
  const auto isRefused = [&](const GuidingSettings& settings, int channel = 0)
  { return !GuidingGradient::Make(field, channel, settings, gradient).IsOk(); };
  EXPECT_TRUE(isRefused(SettingsOf(1.0, 1.0, 1.0, 1.0)));
  EXPECT_TRUE(isRefused(SettingsOf(test::NotANumber, 1.0, 1.0, 1.0)));
  EXPECT_TRUE(isRefused(SettingsOf(0.0, 1.0, 0.0, 1.0)));
  EXPECT_TRUE(isRefused(SettingsOf(0.0, 1.0, test::Infinite, 1.0)));
  EXPECT_TRUE(isRefused(SettingsOf(0.0, 1.0, 1.0, -1.0)));
  EXPECT_TRUE(isRefused(SettingsOf(0.0, 1.0, 1.0, test::NotANumber)));
  EXPECT_TRUE(isRefused(SettingsOf(0.0, 1.0, 1.0, 1.0), 1));
  EXPECT_FALSE(GuidingGradient::Make(nullptr, 0, SettingsOf(0, 1, 1, 1), gradient).IsOk());
  EXPECT_EQ(gradient, nullptr);
}

// The servo's force is that of the field at the hand, with its scale; contact forces come on top.
TEST(GuidingGradient, ActsInFreeSpaceAndInContact)
{
  const auto gradient = GradientOf(FieldOf(Blob), SettingsOf(0.0, 1000.0, 0.5, 1.0));
  TouchScene scene = test::WallScene(0.0, {0.5, 0.0});
  scene.Structures[0].Effects = {gradient};
  scene.Frame = DeviceFrame(Matrix3::Identity(), 2.0, Vector3::Zero());
  test::ServoRun run(scene);
  const Vector3 free = run.RestAt({1.0, 0.0, 2.5});
  EXPECT_EQ(run.Loop.Latest().Structure, -1);
  EXPECT_NEAR((free - gradient->ForceWorld({2.0, 0.0, 5.0})).norm(), 0.0, 1e-14);
  EXPECT_GT(free.norm(), 0.05);
  const Vector3 touching = run.RestAt({2.0, 0.0, -2.0});
  const Vector3 push(0.0, 0.0, 1.0);
  EXPECT_NEAR((touching - push - gradient->ForceWorld({4.0, 0.0, -4.0})).norm(), 0.0, 1e-14);
}

// The energy observer would damp a hand that is led, since the field gives it energy.
TEST(GuidingGradient, LeadsWithoutDamping)
{
  const auto gradient = GradientOf(FieldOf(Blob), SettingsOf(0.0, 1000.0, 0.5, 1.0));
  test::ServoRun run(FreeSpaceWith(gradient));
  run.RestAt({12.0, 0.0, 0.0});
  for (int n = 0; n < 1000; ++n)
  {
    const Vector3 hand(12.0 - 0.01 * n, 0.0, 0.0);
    EXPECT_NEAR((run.TickAt(hand) - gradient->ForceWorld(hand)).norm(), 0.0, 1e-13);
  }
}

TEST(GuidingGradient, FadesFromSceneToScene)
{
  const auto gradient = GradientOf(FieldOf(Blob), SettingsOf(0.0, 1000.0, 0.5, 1.0));
  TouchScene with = FreeSpaceWith(gradient);
  with.Structures[0].Id = 1;
  TouchScene without = with;
  without.Structures[0].Effects.clear();
  test::ServoRun run(without);
  const Vector3 hand(6.0, 0.0, 0.0);
  Vector3 before = run.RestAt(hand);
  EXPECT_EQ(before, Vector3::Zero());
  for (const TouchScene& next : {with, without})
  {
    EXPECT_TRUE(
        run.Loop.Publish(std::make_shared<TouchScene>(next), SceneEntry::Continuing).IsOk());
    for (int n = 0; n < 600; ++n)
    {
      const Vector3 now = run.TickAt(hand);
      EXPECT_LE((now - before).norm(), 1.01 * gradient->ForceWorld(hand).norm() / 100.0);
      before = now;
    }
    const Vector3 expected =
        next.Structures[0].Effects.empty() ? Vector3(Vector3::Zero()) : gradient->ForceWorld(hand);
    EXPECT_NEAR((before - expected).norm(), 0.0, 1e-14);
  }
}

TEST(GuidingGradient, WarningsIncludeItsStiffness)
{
  const auto gradient = GradientOf(FieldOf(Blob), SettingsOf(0.0, 1000.0, 0.5, 1.0));
  ASSERT_GT(gradient->Stiffness(), 0.01);
  DeviceCapabilities device;
  device.MaximumStiffness = 0.5 + 1.5 * gradient->Stiffness();
  TouchScene scene = FreeSpaceWith(gradient);
  EXPECT_TRUE(StiffnessWarnings(scene, device, 1000.0).empty());
  scene.Frame = DeviceFrame(Matrix3::Identity(), 2.0, Vector3::Zero());
  EXPECT_EQ(StiffnessWarnings(scene, device, 1000.0).size(), 1U);
}
} // namespace
} // namespace palpate::guiding_gradient_test
