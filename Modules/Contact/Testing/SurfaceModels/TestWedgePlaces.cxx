#include "IcosahedronDirections.h"
#include "SurfacePhantoms.h"
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
double DeepestMissed(const TouchableSurfaceModel& surface, double radius)
{
  const WedgePlaces places(surface, radius, 0.25 * surface.SmallestRadius());
  Random random(9431);
  test::WorstCase missed;
  for (int i = 0; i < 5000; ++i)
  {
    const auto place = surface.PlaceAt(test::RandomDirection(random));
    if (!places.Contains(place.Direction))
    {
      const Vector3 center = place.PointWorld + radius * place.Normal;
      const double room = surface.Search().Nearest(center).SignedDistance - radius;
      missed.Add(std::min(0.0, room));
    }
  }
  return missed.Value();
}

// Where one wall is said to hold a tool it overlaps no other part, also in hollows between the
// places that are tested. Three micrometres are less than a proof leaves open.
TEST(WedgePlaces, ToolsFitWhereOneWallIsSaidToHoldThem)
{
  Random random(1);
  for (const SurfaceModel& shape : {test::BumpyTube(random), test::CleftBlob(), test::Bowl()})
  {
    std::shared_ptr<const TouchableSurfaceModel> surface;
    ASSERT_TRUE(TouchableSurfaceModel::Make(shape, surface).IsOk());
    for (const double radius : {0.3, 1.0, 4.0})
    {
      EXPECT_LE(DeepestMissed(*surface, radius), 0.003) << radius;
    }
  }
}

TEST(WedgePlaces, AConvexOrganNeedsNone)
{
  for (const int degree : {1, 16})
  {
    std::shared_ptr<const TouchableSurfaceModel> surface;
    ASSERT_TRUE(
        TouchableSurfaceModel::Make(test::EllipsoidPhantom({25.0, 18.0, 9.0}, degree), surface)
            .IsOk());
    for (const double radius : {0.0, 0.5, 4.0})
    {
      const WedgePlaces places(*surface, radius, 1.0);
      EXPECT_TRUE(places.IsEmpty()) << degree << " " << radius;
      const IcosahedronDirections sphere(30);
      for (const Vector3& parameter : sphere.Directions())
      {
        ASSERT_FLOAT_EQ(places.RoomAt(parameter), radius + 1.0);
      }
    }
  }
}

// The wedge takes many times as long, so that few places with room for a larger sphere are left to
// it.
TEST(WedgePlaces, FewPlacesWithRoomNeedTheWedge)
{
  constexpr double Radius = 4.0; // mm
  constexpr double Larger = 1.25;
  constexpr int Trials = 5000;
  Random random(1);
  std::shared_ptr<const TouchableSurfaceModel> surface;
  ASSERT_TRUE(TouchableSurfaceModel::Make(test::BumpyTube(random), surface).IsOk());
  const WedgePlaces places(*surface, Radius, 0.25 * surface->SmallestRadius());
  int needed = 0;
  int more = 0;
  for (int i = 0; i < Trials; ++i)
  {
    const auto place = surface->PlaceAt(test::RandomDirection(random));
    const Vector3 center = place.PointWorld + Larger * Radius * place.Normal;
    const bool hasRoom =
        surface->Search().Nearest(center).SignedDistance > (1.0 - 1e-6) * Larger * Radius;
    const bool isNeeded = places.IsBeside(place.Direction);
    needed += isNeeded ? 1 : 0;
    more += isNeeded && hasRoom ? 1 : 0;
  }
  EXPECT_GT(needed, Trials / 20);
  EXPECT_LT(more, Trials / 50) << more;
}

TEST(WedgePlaces, TrackersShareThemUntilTheToolChanges)
{
  Random random(1);
  std::shared_ptr<const TouchableSurfaceModel> surface;
  ASSERT_TRUE(TouchableSurfaceModel::Make(test::BumpyTube(random), surface).IsOk());
  const auto first = surface->PlacesFor(1.0, 0.5);
  EXPECT_EQ(surface->PlacesFor(1.0, 0.5), first);
  EXPECT_NE(surface->PlacesFor(1.5, 0.5), first);
  EXPECT_NE(surface->PlacesFor(1.0, 0.0), first);
}
} // namespace
} // namespace palpate::wedge_places_test
