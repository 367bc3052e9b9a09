#include "RecordedTouches.h"

#include "MessageOf.h"
#include "RandomShapes.h"
#include "TemporaryFolder.h"
#include "TouchRecorder.h"
#include "TouchRecording.h"
#include "TouchedPointsFile.h"

#include <gtest/gtest.h>

namespace palpate::recorded_touches_test
{
namespace
{
constexpr double Radius = 20.0;
constexpr double ToolRadius = 2.0;

// A tool that is pushed into a ball there, or is 5 mm above it.
TouchState TickAt(const Vector3& direction, bool touches = true, int structure = 0)
{
  TouchState tick;
  tick.HasSample = true;
  tick.Structure = touches ? structure : -1;
  tick.ProxyWorld = (Radius + ToolRadius + (touches ? 0.0 : 5.0)) * direction;
  tick.ProbeWorld = (Radius + ToolRadius + (touches ? -0.7 : 5.0)) * direction;
  return tick;
}

// A walk over the whole ball, with a rest and ticks in the air.
std::vector<TouchState> Walk()
{
  test::Random random(57);
  std::vector<TouchState> ticks;
  for (int n = 0; n < 4000; ++n)
  {
    const double angle = 0.1 * n;
    const double up = std::cos(M_PI * n / 4000.0);
    const double out = std::sqrt(1.0 - up * up);
    const Vector3 direction(out * std::cos(angle), out * std::sin(angle), up);
    for (int rest = n == 2000 ? 500 : 1; rest > 0; --rest)
    {
      ticks.push_back(TickAt(direction, random() % 5 != 0));
    }
  }
  for (std::size_t n = 0; n < ticks.size(); ++n)
  {
    ticks[n].Tick.Number = n;
    ticks[n].Tick.Scheduled = static_cast<std::int64_t>(1000000 * n);
    ticks[n].Tick.Started = ticks[n].Tick.Scheduled;
  }
  return ticks;
}

RecordedTouchSettings Settings(double spacing = 5.0, std::size_t most = 1000)
{
  return {ToolRadius, 0.3, spacing, most};
}

TEST(RecordedTouches, LieOnTheSurfaceWithItsNormals)
{
  const TouchRecording recording{{}, Walk()};
  const auto touches = TouchesOf(recording, Settings());
  ASSERT_GT(touches.size(), 30U);
  for (const SurfaceTouch& touch : touches)
  {
    EXPECT_NEAR(touch.PointWorld.norm(), Radius, 1e-9);
    ASSERT_TRUE(touch.Normal);
    EXPECT_LT((*touch.Normal - touch.PointWorld.normalized()).norm(), 1e-9);
    EXPECT_EQ(touch.Deviation, 0.3);
    EXPECT_EQ(touch.Stroke, 0);
  }
}

TEST(RecordedTouches, AreThinnedToTheSpacingAndLeaveNoPlaceOut)
{
  const TouchRecording recording{{}, Walk()};
  const auto touches = TouchesOf(recording, Settings());
  for (const TouchState& tick : recording.Ticks)
  {
    double nearest = 1e9;
    for (const SurfaceTouch& touch : touches)
    {
      const Vector3 point = Radius * Vector3(tick.ProxyWorld).normalized();
      nearest = std::min(nearest, (touch.PointWorld - point).norm());
    }
    EXPECT_LT(nearest, tick.Structure < 0 ? 10.0 : 5.0);
  }
  for (std::size_t n = 1; n < touches.size(); ++n)
  {
    for (std::size_t other = 0; other < n; ++other)
    {
      EXPECT_GE((touches[n].PointWorld - touches[other].PointWorld).norm(), 5.0);
    }
  }
  const auto few = TouchesOf(recording, Settings(5.0, 40));
  EXPECT_LE(few.size(), 40U);
  EXPECT_GE(few.size(), 10U);
}

TEST(RecordedTouches, AreOfTheStructureTouchedLongestWhereItIsFelt)
{
  TouchRecording recording;
  recording.Ticks = {TickAt(Vector3::UnitX(), true, 1), TickAt(Vector3::UnitY(), true, 1),
                     TickAt(Vector3::UnitZ(), true, 0)};
  EXPECT_EQ(TouchesOf(recording, Settings()).size(), 2U);
  recording.Ticks[0].IsClutched = true;
  recording.Ticks[1].PatchRadius = 2.0;
  const auto one = TouchesOf(recording, Settings());
  ASSERT_EQ(one.size(), 1U);
  EXPECT_GT(one[0].PointWorld.z(), 19.0);
  recording.Ticks[2].IsBuried = true;
  EXPECT_TRUE(TouchesOf(recording, Settings()).empty());
  EXPECT_TRUE(TouchesOf({}, Settings()).empty());
}

TEST(RecordedTouches, AreReadAsOtherTouchedPoints)
{
  const test::TemporaryFolder folder;
  const auto write = [&](const std::string& name, const std::vector<TouchState>& ticks)
  {
    TouchRecorder recorder;
    EXPECT_TRUE(recorder.Start((folder / name).string(), {}).IsOk());
    for (const TouchState& tick : ticks)
    {
      EXPECT_TRUE(recorder.Take(tick).IsOk());
    }
    EXPECT_TRUE(recorder.Finish().IsOk());
    return folder / name;
  };
  const auto read = ReadTouchedPoints(write("walk.touch", Walk()), 0.3, ToolRadius);
  EXPECT_EQ(read, TouchesOf({{}, Walk()}, {ToolRadius, 0.3}));
  EXPECT_LE(read.size(), 100U);
  TouchState apart = TickAt(Vector3::UnitX(), false);
  EXPECT_TRUE(test::Contains(
      test::MessageOf([&] { ReadTouchedPoints(write("air.touch", {apart}), 0.3, ToolRadius); }),
      "air.touch"));
  test::WriteAll(folder / "bad.touch", "not a recording");
  EXPECT_TRUE(test::Contains(
      test::MessageOf([&] { ReadTouchedPoints(folder / "bad.touch", 0.3, ToolRadius); }),
      "bad.touch"));
}
} // namespace
} // namespace palpate::recorded_touches_test
