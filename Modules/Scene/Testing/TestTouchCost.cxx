#include "TouchCost.h"

#include "HandPath.h"
#include "InputError.h"
#include "Progress.h"
#include "SteadyClock.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::touch_cost_test
{
namespace
{
constexpr double Radius = 20.0;

TouchContact Sphere()
{
  const RadialModel model(0, {Radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero());
  return MakeModelContact(model, RadialContactMode::Nearest, "ball");
}

bool GoOn(double /*fraction*/, const std::string& /*stage*/)
{
  return true;
}

// A clock on which every measured time equals one reading of it.
class CountingClock final : public Clock
{
public:
  std::int64_t Now() const noexcept override { return this->Time += Glance; }
  void WaitUntil(std::int64_t time) noexcept override { this->Time = time; }
  static constexpr std::int64_t Glance = 1234; // ns

private:
  mutable std::int64_t Time = 0;
};

TEST(TouchCost, EqualsTheMedianOnTheClock)
{
  const CountingClock clock;
  const TouchCost cost = MeasureTouchCost(Sphere(), {}, clock, GoOn);
  EXPECT_EQ(cost.MedianNanoseconds, static_cast<double>(CountingClock::Glance));
  EXPECT_GT(cost.Ticks, 1000U) << "24 presses of some 10 mm in steps of 0.05 mm";
}

TEST(TouchCost, IsPositiveAndFinite)
{
  const SteadyClock clock;
  const TouchCost cost = MeasureTouchCost(Sphere(), {}, clock, GoOn);
  EXPECT_GT(cost.MedianNanoseconds, 0.0);
  EXPECT_TRUE(std::isfinite(cost.MedianNanoseconds));
}

TEST(TouchCost, RejectsToolThatCannotTouch)
{
  const SteadyClock clock;
  TouchToolSettings tool;
  tool.Kind = TouchToolSettings::Shape::Ellipsoid; // harmonics require a sphere
  EXPECT_THROW(static_cast<void>(MeasureTouchCost(Sphere(), tool, clock, GoOn)), InputError);
}

TEST(TouchCost, CanBeCancelled)
{
  const SteadyClock clock;
  const auto stop = [](double /*fraction*/, const std::string& /*stage*/) { return false; };
  EXPECT_THROW(static_cast<void>(MeasureTouchCost(Sphere(), {}, clock, stop)), Cancelled);
}

TEST(HandPresses, ReachExactlyTheirDepthAndRepeatForASeed)
{
  TouchScene scene;
  scene.Tool = ToolShape::Sphere(2.0);
  scene.Structures.emplace_back();
  scene.Structures.front().Model = Sphere().Model;
  HandPresses presses;
  presses.Aside = 0.0;
  HandPath path;
  ASSERT_TRUE(PressesOf(scene, presses, path).IsOk());
  double deepest = 0.0;
  for (const HandPath::Place& place : path.List())
  {
    deepest = std::max(deepest, Radius + 2.0 - place.PointWorld.norm());
  }
  // The first contact is found to 2^-12 of a step of a few tenths of a millimetre.
  EXPECT_NEAR(deepest, presses.Depth, 0.01);
  HandPath again;
  ASSERT_TRUE(PressesOf(scene, presses, again).IsOk());
  ASSERT_EQ(again.List().size(), path.List().size());
  EXPECT_EQ(again.List().back().PointWorld, path.List().back().PointWorld);
  presses.Seed = 2;
  ASSERT_TRUE(PressesOf(scene, presses, again).IsOk());
  EXPECT_NE(again.List().back().PointWorld, path.List().back().PointWorld);
}
} // namespace
} // namespace palpate::touch_cost_test
