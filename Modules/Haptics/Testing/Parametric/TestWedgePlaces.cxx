#include "ParametricPhantoms.h"
#include "WedgePlaces.h"
#include "WorstCase.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace palpate::wedge_places_test
{
namespace
{
using test::Random;

// How far another part of the surface is in a tool that touches where one wall is said to hold it.
double DeepestMissed(const ParametricTouchSurface& surface, double radius)
{
  const WedgePlaces places(surface, radius, 0.25 * surface.SmallestRadius());
  Random random(9431);
  test::WorstCase missed;
  for (int i = 0; i < 5000; ++i)
  {
    const auto place = surface.PlaceAt(test::RandomDirection(random));
    if (!places.IsBeside(place.Direction))
    {
      const Vector3 center = place.PointWorld + radius * place.Normal;
      const double room = surface.Search().Nearest(center).SignedDistance - radius;
      missed.Add(std::min(0.0, room));
    }
  }
  return missed.Value();
}

// Hollows that are narrower between the places that are tested first than there.
TEST(WedgePlaces, HollowsBetweenTestedPlacesAreFound)
{
  constexpr double Radius = 4.0;
  Random random(1);
  std::shared_ptr<const ParametricTouchSurface> surface;
  ASSERT_TRUE(ParametricTouchSurface::Make(test::BumpyTube(random), surface).IsOk());
  EXPECT_LE(DeepestMissed(*surface, Radius), 2e-3 * Radius);
}

TEST(WedgePlaces, TrackersShareThemUntilTheToolChanges)
{
  Random random(1);
  std::shared_ptr<const ParametricTouchSurface> surface;
  ASSERT_TRUE(ParametricTouchSurface::Make(test::BumpyTube(random), surface).IsOk());
  const auto first = surface->PlacesFor(1.0, 0.5);
  EXPECT_EQ(surface->PlacesFor(1.0, 0.5), first);
  EXPECT_NE(surface->PlacesFor(1.5, 0.5), first);
  EXPECT_NE(surface->PlacesFor(1.0, 0.0), first);
}
} // namespace
} // namespace palpate::wedge_places_test
