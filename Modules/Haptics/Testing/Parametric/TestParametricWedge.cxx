#include "HarmonicWedge.h"
#include "ParametricPhantoms.h"
#include "WedgePlaces.h"

#include <gtest/gtest.h>

namespace palpate::parametric_wedge_test
{
namespace
{
using test::Random;
using Wedge = HarmonicWedgeOf<ParametricTouchSurface>;

// A sphere that is put over one wall of a cleft that is too narrow for it, as if most of the sphere
// were known to be free: the first tick proves little, and friction may hold it from then on.
TEST(ParametricWedge, LeavesWallsWhileItStays)
{
  std::shared_ptr<const ParametricTouchSurface> surface;
  ASSERT_TRUE(ParametricTouchSurface::Make(test::CleftBlob(), surface).IsOk());
  constexpr double Radius = 4.0; // mm, wider than the cleft
  constexpr int Ticks = 40;
  const WedgePlaces places(*surface, Radius, 0.0);
  const double most = 3.1e-3 * surface->SmallestRadius(); // of which 3e-3 are left open
  const auto overlapAt = [&](const Vector3& place)
  { return Radius - surface->SeenFrom(place, surface->Search().Nearest(place)).SignedDistance; };
  Random random(9114);
  int late = 0;
  for (int trial = 0; trial < 1500; ++trial)
  {
    const auto foot = surface->PlaceAt(test::RandomDirection(random));
    const Vector3 place = foot.PointWorld + Radius * foot.Normal;
    if (!places.Contains(foot.Direction) || overlapAt(place) > 0.4 * Radius)
    {
      continue;
    }
    Wedge wedge(surface, Radius);
    wedge.Begin(surface->Search().Track(place, surface->Search().Nearest(foot.PointWorld)),
                {place, 0.9 * Radius});
    wedge.MoveTo(place - 0.1 * foot.Normal);
    late += overlapAt(wedge.CenterWorld()) > most ? 1 : 0;
    for (int tick = 0; tick < Ticks; ++tick)
    {
      wedge.Stay();
    }
    EXPECT_LE(overlapAt(wedge.CenterWorld()), most) << trial;
  }
  EXPECT_GT(late, 5);
}
} // namespace
} // namespace palpate::parametric_wedge_test
