#include "UncertainStiffness.h"

#include "ContactCases.h"
#include "FeltCases.h"
#include "RandomOrientation.h"

#include <cmath>
#include <limits>

namespace palpate::uncertain_stiffness_test
{
namespace
{
constexpr double Radius = 20.0; // mm, of a sphere around the origin
constexpr double Own = 0.5;     // N/mm

std::vector<Vector3> Sphere()
{
  test::Random random(64);
  std::vector<Vector3> points;
  for (int n = 0; n < 642; ++n)
  {
    points.push_back(Radius * test::RandomDirection(random));
  }
  return points;
}

std::shared_ptr<const StiffnessImage>
StiffnessOf(const std::vector<Vector3>& points,
            const std::function<double(const Vector3&)>& deviationAt)
{
  std::vector<double> deviations;
  for (const Vector3& point : points)
  {
    deviations.push_back(deviationAt(point));
  }
  std::shared_ptr<const StiffnessImage> made;
  const Status status = MakeUncertainStiffness(points, deviations, Own, made);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return made;
}

// Surer above, from 0.5 to 3.5 mm.
double Sloping(const Vector3& point)
{
  return 2.0 - 1.5 * point.z() / Radius;
}

TEST(UncertainStiffness, PushOfOneNewtonGoesOneDeviationDeeper)
{
  const std::vector<Vector3> points = Sphere();
  for (const double deviation : {0.0, 0.3, 2.0, 12.0})
  {
    const auto stiffness = StiffnessOf(points, [&](const Vector3&) { return deviation; });
    for (const Vector3& point : points)
    {
      // 1 N into springs in series.
      EXPECT_NEAR(1.0 / stiffness->StiffnessAt(Own, point), 1.0 / Own + deviation, 1e-9);
    }
  }
}

TEST(UncertainStiffness, FollowsTheDeviationsBetweenPoints)
{
  const auto stiffness = StiffnessOf(Sphere(), Sloping);
  test::Random random(65);
  for (int n = 0; n < 2000; ++n)
  {
    const Vector3 place = Radius * test::RandomDirection(random);
    // Half a voxel and the distance of random points, 4 mm together, of a slope of 0.075 mm per mm.
    EXPECT_NEAR(1.0 / stiffness->StiffnessAt(Own, place) - 1.0 / Own, Sloping(place), 0.3);
  }
}

TEST(UncertainStiffness, IsNeverStifferThanTheStructure)
{
  test::Random random(66);
  const auto stiffness = StiffnessOf(Sphere(), [](const Vector3& point)
                                     { return std::exp(3.0 * std::sin(point.sum())); });
  std::uniform_real_distribution<double> place(-40.0, 40.0);
  for (int n = 0; n < 20000; ++n)
  {
    const double there = stiffness->StiffnessAt(Own, {place(random), place(random), place(random)});
    EXPECT_LE(there, Own * (1.0 + 1e-12));
    EXPECT_GT(there, 0.0);
  }
  EXPECT_EQ(stiffness->LargestStiffness(Own), Own);
  EXPECT_EQ(stiffness->StiffnessAt(Own, {90.0, 0.0, 0.0}), Own) << "far away";
}

// The next touch makes one side surer: the resting hand's force does not rise, nor step.
TEST(UncertainStiffness, HandThatRestsFeelsNoJumpAtAnUpdate)
{
  const auto sceneOf = [](const std::shared_ptr<const StiffnessImage>& stiffness)
  {
    TouchScene scene;
    scene.Tool = ToolShape::Sphere(1.0);
    scene.Structures.push_back(
        {"drawn",
         test::RadialContact({0, {Radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()}),
         {Own, 0.0},
         {}});
    scene.Structures[0].Id = 7;
    scene.Structures[0].Effects = {stiffness};
    return scene;
  };
  const Vector3 pressed(0.3, 0.2, Radius - 1.0);
  const auto restedOn = [&](const TouchScene& scene)
  {
    test::ServoRun run(scene);
    return run.MoveAndRest({0.3, 0.2, Radius + 5.0}, pressed).norm();
  };
  const TouchScene unsure = sceneOf(StiffnessOf(Sphere(), [](const Vector3&) { return 4.0; }));
  const TouchScene surer = sceneOf(StiffnessOf(Sphere(), [](const Vector3&) { return 0.5; }));
  EXPECT_GT(restedOn(surer), 2.0 * restedOn(unsure)) << "otherwise there is nothing to jump";
  for (const bool becomesSurer : {true, false})
  {
    test::ServoRun run(becomesSurer ? unsure : surer);
    const Vector3 first = run.MoveAndRest({0.3, 0.2, Radius + 5.0}, pressed);
    ASSERT_TRUE(run.Loop
                    .Publish(std::make_shared<TouchScene>(becomesSurer ? surer : unsure),
                             SceneEntry::Continuing)
                    .IsOk());
    Vector3 last = first;
    for (int n = 0; n < 600; ++n)
    {
      const Vector3 force = run.TickAt(pressed);
      EXPECT_LE((force - last).norm(), 0.025 * first.norm()) << "tick " << n;
      EXPECT_LE(force.norm(), 1.001 * first.norm()) << "tick " << n;
      last = force;
    }
  }
}

TEST(UncertainStiffness, RefusesWhatIsNoSurface)
{
  const double infinite = std::numeric_limits<double>::infinity();
  std::shared_ptr<const StiffnessImage> made;
  const auto isRefused =
      [&made](const std::vector<Vector3>& points, const std::vector<double>& deviations, double own)
  { return !MakeUncertainStiffness(points, deviations, own, made).IsOk() && made == nullptr; };
  EXPECT_TRUE(isRefused({}, {}, Own));
  EXPECT_TRUE(isRefused({Vector3::Zero()}, {1.0, 2.0}, Own));
  EXPECT_TRUE(isRefused({Vector3::Zero()}, {-1.0}, Own));
  EXPECT_TRUE(isRefused({Vector3::Zero()}, {std::nan("")}, Own));
  EXPECT_TRUE(isRefused({Vector3(infinite, 0.0, 0.0)}, {1.0}, Own));
  EXPECT_TRUE(isRefused({Vector3::Zero(), Vector3(2000.0, 0.0, 0.0)}, {1.0, 1.0}, Own));
  EXPECT_TRUE(isRefused({Vector3::Zero()}, {1.0}, infinite));
  EXPECT_TRUE(MakeUncertainStiffness({Vector3::Zero()}, {1.0}, Own, made).IsOk());
}
} // namespace
} // namespace palpate::uncertain_stiffness_test
