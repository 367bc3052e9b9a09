#include "GuideField.h"

#include "RandomOrientation.h"
#include "ServoRun.h"
#include "StiffnessAdvice.h"

#include <cmath>

namespace palpate::guide_field_test
{
namespace
{
GuideSettings GuideOf(GuideShape shape, std::vector<Vector3> points)
{
  GuideSettings settings;
  settings.Shape = shape;
  settings.PointsWorld = std::move(points);
  settings.Stiffness = 0.1;
  settings.Range = 8.0;
  settings.LargestForce = 2.0;
  return settings;
}

GuideSettings PointGuide()
{
  return GuideOf(GuideShape::Point, {{1.0, 2.0, 3.0}});
}

// A square corner and a way back beside it.
GuideSettings PathGuide()
{
  return GuideOf(GuideShape::Path,
                 {{0.0, 0.0, 0.0}, {20.0, 0.0, 0.0}, {20.0, 20.0, 0.0}, {2.0, 4.0, 3.0}});
}

GuideSettings PlaneGuide()
{
  return GuideOf(GuideShape::Plane, {{0.0, 0.0, 4.0}, {10.0, 0.0, 4.0}, {0.0, 5.0, 4.0}});
}

std::shared_ptr<const ForceField> Made(const GuideSettings& settings)
{
  std::shared_ptr<const ForceField> guide;
  const Status status = GuideField::Make(settings, guide);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return guide;
}

double LawAt(double distance)
{
  const double left = std::max(0.0, 1.0 - distance * distance / 64.0);
  return 0.1 * distance * left * left;
}

TEST(GuideField, PullsTowardsTheNearestPoint)
{
  const Vector3 up = Vector3::UnitZ();
  const Vector3 point = Made(PointGuide())->ForceWorld({1.0, 2.0, 6.0});
  EXPECT_NEAR((point + LawAt(3.0) * up).norm(), 0.0, 1e-15);
  const Vector3 plane = Made(PlaneGuide())->ForceWorld({70.0, -80.0, 2.0});
  EXPECT_NEAR((plane - LawAt(2.0) * up).norm(), 0.0, 1e-14);
  const auto path = Made(PathGuide());
  EXPECT_NEAR((path->ForceWorld({12.0, 0.0, 1.5}) + LawAt(1.5) * up).norm(), 0.0, 1e-15);
  // Beyond its end, back to the end.
  const Vector3 out(-0.6, 0.0, -0.8);
  EXPECT_NEAR((path->ForceWorld(5.0 * out) + LawAt(5.0) * out).norm(), 0.0, 1e-15);
  const auto line = Made(GuideOf(GuideShape::Path, {{0.0, 0.0, 0.0}, {20.0, 0.0, 0.0}}));
  const Vector3 along = Vector3::UnitX();
  EXPECT_NEAR((line->ForceWorld(23.0 * along) + LawAt(3.0) * along).norm(), 0.0, 1e-15);
}

TEST(GuideField, EndsSmoothlyAtItsRange)
{
  const auto guide = Made(PointGuide());
  const Vector3 center(1.0, 2.0, 3.0);
  test::Random random(831);
  for (int n = 0; n < 1000; ++n)
  {
    const Vector3 out = test::RandomDirection(random);
    EXPECT_EQ(guide->ForceWorld(center + 8.001 * out), Vector3::Zero());
    EXPECT_LT(guide->ForceWorld(center + 7.99 * out).norm(), 1e-5);
    EXPECT_TRUE(guide->BoundsWorld().contains(center + 7.99 * out));
  }
}

// Also from one part of the path to the other, where the force turns in a step: there the error is
// that step's force times half a step of the path.
TEST(GuideField, ClosedPathsDoNoWork)
{
  test::Random random(832);
  for (const GuideSettings& settings : {PointGuide(), PathGuide(), PlaneGuide()})
  {
    const auto guide = Made(settings);
    double largest = 0.0;
    for (int path = 0; path < 5; ++path)
    {
      const Matrix3 turn = test::RandomOrientation(random);
      const auto around = [&turn](double turned)
      {
        const double angle = 2.0 * M_PI * turned;
        return Vector3(Vector3(8.0, 4.0, 3.0) + turn * Vector3(9.0 * std::cos(angle),
                                                               7.0 * std::sin(angle),
                                                               2.0 * std::sin(2.0 * angle)));
      };
      constexpr int Steps = 100'000;
      double work = 0.0;
      for (int n = 0; n < Steps; ++n)
      {
        const Vector3 from = around(1.0 * n / Steps);
        const Vector3 to = around((n + 1.0) / Steps);
        const Vector3 force = guide->ForceWorld(0.5 * (from + to));
        work += force.dot(to - from);
        largest = std::max(largest, force.norm());
      }
      EXPECT_NEAR(work, 0.0, 3e-4); // N mm
    }
    EXPECT_GT(largest, 0.15);
  }
}

TEST(GuideField, LargestForceAndStiffnessHoldEverywhere)
{
  test::Random random(833);
  std::uniform_real_distribution<double> coordinate(-12.0, 32.0);
  for (GuideSettings settings : {PointGuide(), PathGuide(), PlaneGuide()})
  {
    for (const double largest : {0.05, 2.0})
    {
      settings.LargestForce = largest;
      const auto guide = Made(settings);
      double most = 0.0;
      for (int n = 0; n < 100'000; ++n)
      {
        const Vector3 place(coordinate(random), coordinate(random), coordinate(random));
        most = std::max(most, guide->ForceWorld(place).norm());
      }
      EXPECT_LE(most, std::min(largest, 0.2862168 * 0.1 * 8.0) * (1.0 + 1e-12));
      EXPECT_GT(most, 0.95 * std::min(largest, 0.286 * 0.1 * 8.0));
      EXPECT_LE(guide->Stiffness(), 0.1);
    }
  }
}

TEST(GuideField, RejectsInvalidGuides)
{
  std::shared_ptr<const ForceField> guide;
  const auto isRefused = [&](const GuideSettings& settings)
  { return !GuideField::Make(settings, guide).IsOk(); };
  EXPECT_TRUE(isRefused(GuideOf(GuideShape::Point, {})));
  EXPECT_TRUE(isRefused(GuideOf(GuideShape::Path, {{1.0, 2.0, 3.0}})));
  EXPECT_TRUE(isRefused(GuideOf(GuideShape::Plane, {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}})));
  EXPECT_TRUE(isRefused(GuideOf(GuideShape::Point, {{test::NotANumber, 2.0, 3.0}})));
  EXPECT_TRUE(isRefused(GuideOf(GuideShape::Point, {{1e7, 2.0, 3.0}})));
  EXPECT_TRUE(isRefused(GuideOf(GuideShape::Path, std::vector<Vector3>(1001, Vector3::Zero()))));
  for (double GuideSettings::*number :
       {&GuideSettings::Stiffness, &GuideSettings::Range, &GuideSettings::LargestForce})
  {
    for (const double bad : {0.0, -1.0, test::NotANumber, test::Infinite})
    {
      GuideSettings settings = PointGuide();
      settings.*number = bad;
      EXPECT_TRUE(isRefused(settings));
    }
  }
  EXPECT_EQ(guide, nullptr);
}

TEST(GuideField, IsFiniteForHostilePlaces)
{
  test::Random random(834);
  for (const GuideSettings& settings : {PointGuide(), PathGuide(), PlaneGuide()})
  {
    const auto guide = Made(settings);
    for (int n = 0; n < 20'000; ++n)
    {
      EXPECT_LE(guide->ForceWorld(test::HostileVector(random)).norm(), 2.0);
    }
  }
}

// Through the servo, without contact and with a frame of twice the scale; undamped while it leads.
TEST(GuideField, GuidesInAScene)
{
  TouchScene scene = test::WallScene(-50.0, {0.5, 0.0});
  scene.Frame = DeviceFrame(Matrix3::Identity(), 2.0, Vector3::Zero());
  scene.Fields = {Made(PlaneGuide())};
  test::ServoRun run(scene);
  run.RestAt({1.0, 0.0, 4.5});
  for (int n = 0; n < 400; ++n)
  {
    const double height = 4.5 - 0.005 * n;
    const Vector3 expected(0.0, 0.0, -LawAt(2.0 * height - 4.0));
    EXPECT_NEAR((run.TickAt({1.0, 0.0, height}) - expected).norm(), 0.0, 1e-13);
  }
}

TEST(GuideField, FadesInAndOutFromSceneToScene)
{
  TouchScene without = test::WallScene(-50.0, {0.5, 0.0});
  TouchScene with = without;
  with.Fields = {Made(PointGuide())};
  test::ServoRun run(without);
  const Vector3 hand(1.0, 2.0, 6.0);
  Vector3 before = run.RestAt(hand);
  for (const TouchScene& next : {with, without, with})
  {
    EXPECT_TRUE(
        run.Loop.Publish(std::make_shared<TouchScene>(next), SceneEntry::Continuing).IsOk());
    for (int n = 0; n < 300; ++n)
    {
      const Vector3 now = run.TickAt(hand);
      EXPECT_LE((now - before).norm(), 1.01 * LawAt(3.0) / 100.0);
      before = now;
    }
    EXPECT_NEAR(before.norm(), next.Fields.empty() ? 0.0 : LawAt(3.0), 1e-14);
  }
}

TEST(GuideField, WarningsIncludeIt)
{
  DeviceCapabilities device;
  device.MaximumStiffness = 0.55;
  TouchScene scene = test::WallScene(0.0, {0.5, 0.0});
  EXPECT_TRUE(StiffnessWarnings(scene, device, 1000.0).empty());
  scene.Fields = {Made(PointGuide())};
  EXPECT_EQ(StiffnessWarnings(scene, device, 1000.0).size(), 1U);
}

TEST(GuideField, MissingFieldIsRefused)
{
  TouchScene scene = test::WallScene(0.0, {0.5, 0.0});
  scene.Fields = {nullptr};
  EXPECT_FALSE(scene.Check().IsOk());
}
} // namespace
} // namespace palpate::guide_field_test
