#include "ClearMotion.h"
#include "SurfaceModelPath.h"
#include "SurfacePhantoms.h"
#include "WorstCase.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace palpate::clear_motion_test
{
namespace
{
using test::Random;
using test::WorstCase;

// A step may overlap several walls at once. The tool touches the one that it reached first, so
// nothing overlaps it there.
TEST(ClearMotion, ContactBeginsAtTheFirstWallOfAStep)
{
  std::shared_ptr<const TouchableSurfaceModel> surface;
  ASSERT_TRUE(TouchableSurfaceModel::Make(test::CleftBlob(), surface).IsOk());
  constexpr double Radius = 4.0; // mm, wider than the cleft
  constexpr double Step = 0.3;   // mm
  const double stride = surface->SmallestRadius() / 16.0;
  constexpr double Exactness = 1e-5; // mm
  constexpr int Evaluations = 1000;
  const WedgePlaces places(*surface, Radius, 0.0);
  ClearMotion motion(*surface, places, Radius, stride, Exactness, nullptr);
  Random random(9301);
  WorstCase overlap;
  int meetings = 0;
  while (meetings < 300)
  {
    const auto foot = surface->PlaceAt(test::RandomDirection(random));
    if (!places.Contains(foot.Direction))
    {
      continue;
    }
    Vector3 place = foot.PointWorld + (Radius + 2.0) * foot.Normal;
    const Vector3 step = Step * (0.5 * test::RandomDirection(random) - foot.Normal).normalized();
    const auto nearest = surface->SeenFrom(place, surface->Search().Nearest(place));
    if (nearest.SignedDistance < Radius + Step)
    {
      continue;
    }
    motion.Begin(place, nearest);
    bool isFree = true;
    for (int tick = 0; tick < 30 && isFree; ++tick)
    {
      place += step;
      isFree = motion.MoveTo(place, Evaluations);
    }
    if (!isFree)
    {
      ++meetings;
      const double room = surface->Search().Nearest(motion.PlaceWorld()).SignedDistance - Radius;
      overlap.Add(std::min(0.0, room));
    }
  }
  // What curves within a step, and what a proof may leave.
  EXPECT_LE(overlap.Value(), 2e-3 * surface->SmallestRadius());
}
} // namespace
} // namespace palpate::clear_motion_test
