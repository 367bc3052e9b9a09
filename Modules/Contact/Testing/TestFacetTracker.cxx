#include "FrictionCone.h"
#include "MeshCases.h"
#include "WorstCase.h"

#include <limits>

namespace palpate::facet_tracker_test
{
namespace
{
using test::At;
using test::FacetContact;
using test::Random;
using test::TrackerOf;
using test::WorstCase;

// The skin between tool and facets, 1e-6 of a diagonal of some 100 mm, and as much for rounding.
constexpr double SkinError = 2e-4;

TEST(FacetTracker, ProxyOnABoxIsTheNearestPlaceOnItsSide)
{
  const auto model = FacetContact(test::BoxMesh({10.0, 10.0, 10.0}));
  for (const double radius : {0.0, 1.5})
  {
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(radius));
    tracker->Follow(At({1.0, 2.0, 20.0}));
    for (int tick = 0; tick < 100; ++tick)
    {
      const Vector3 probe(0.08 * tick, 2.0 - 0.08 * tick, 10.0 + radius - 2.0);
      const Contact& contact = tracker->Follow(At(probe));
      ASSERT_TRUE(contact.IsTouching);
      EXPECT_LE((contact.ProxyWorld - Vector3(probe[0], probe[1], 10.0 + radius)).norm(),
                SkinError);
      EXPECT_LE((contact.NormalWorld - Vector3::UnitZ()).norm(), 1e-9); // rounding
    }
    // Beyond the edge it loses contact.
    EXPECT_FALSE(tracker->Follow(At({12.5 + radius, 0.0, 8.0})).IsTouching);
  }
}

TEST(FacetTracker, RestsOnBothOfTwoBoxes)
{
  // A step: a floor, and a wall on it.
  test::Mesh step = test::BoxMesh({10.0, 10.0, 1.0});
  const test::Mesh wall = test::BoxMesh({1.0, 10.0, 10.0});
  for (const FacetTree::Triangle& t : wall.Triangles)
  {
    step.Triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  }
  for (const Vector3& p : wall.Points)
  {
    step.Points.push_back(p + Vector3(-9.0, 0.0, 9.0));
  }
  const auto model = FacetContact(step);
  for (const double radius : {0.0, 2.0})
  {
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(radius));
    const Vector3 rest(-8.0 + radius, 0.0, 1.0 + radius);
    tracker->Follow(At(rest + Vector3(3.0, 0.0, 3.0)));
    const Contact& contact = tracker->Follow(At(rest + Vector3(-0.9, 0.5, -0.7)));
    ASSERT_TRUE(contact.IsTouching);
    EXPECT_LE((contact.ProxyWorld - rest - Vector3(0.0, 0.5, 0.0)).norm(), SkinError);
    EXPECT_NEAR(contact.Depth, std::hypot(0.9, 0.7), SkinError);
  }
}

TEST(FacetTracker, ProxiesAreNearestPlacesAlongServoPaths)
{
  Random random(6201);
  const RadialModel organ = test::RandomOrgan(random, 12);
  const auto mesh = test::MeshOf(organ, 20);
  const auto tree = test::TreeOf(mesh);
  const auto model = FacetContact(mesh);
  for (const double radius : {0.0, 1.0})
  {
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(radius));
    test::WanderingDirection wandering(random);
    WorstCase farther;
    WorstCase gap;
    for (int tick = 0; tick < 1500; ++tick)
    {
      const Vector3 u = wandering.Next(0.0025);
      const Vector3 probe = organ.PointWorld(u) + (radius - 1.5) * organ.Normal(u);
      const Contact& contact = tracker->Follow(At(probe));
      ASSERT_TRUE(contact.IsTouching);
      gap.Add(tree->NearestTo(contact.ProxyWorld, 10.0).Distance - radius);
      const double least = tree->NearestTo(probe, 10.0).Distance;
      // Inside, the distance to the offset surface is at most that to the mesh plus the radius.
      farther.Add(std::max(0.0, contact.Depth - least - radius));
    }
    // Where rounds end, the last move along a plane misses a rounded edge by s^2 / 2 radius.
    EXPECT_LE(gap.Value(), 0.002) << radius;
    // A god-object on facets waits on an edge until the pull has passed both its normals.
    EXPECT_LE(farther.Value(), 0.02) << radius;
  }
}

TEST(FacetTracker, PassesThroughNothingAtAnySpeed)
{
  Random random(6202);
  const auto model = FacetContact(test::BoxMesh({10.0, 10.0, 0.01}));
  for (const double radius : {0.0, 1.0})
  {
    for (const double step : {0.001, 0.1, 1.0, 100.0}) // mm per tick: up to 100 m/s at 1 kHz
    {
      const auto tracker = TrackerOf(*model, ToolShape::Sphere(radius));
      const double high = step < 0.01 ? 0.1 : 50.0;
      const Vector3 from = test::RandomDirection(random) + Vector3(0.0, 0.0, radius + high + 1.0);
      const Vector3 to = test::RandomDirection(random) - Vector3(0.0, 0.0, radius + 1.5);
      tracker->Follow(At(from));
      Contact last;
      test::MoveStraight(*tracker, from, to, step,
                         [&](const Vector3&, const Contact& contact) { last = contact; });
      ASSERT_TRUE(last.IsTouching);
      EXPECT_NEAR(last.ProxyWorld[2], radius + 0.01, SkinError) << radius << " " << step;
    }
  }
}

TEST(FacetTracker, SticksWithinTheFrictionConeAndSlipsToIt)
{
  const auto model = FacetContact(test::BoxMesh({10.0, 10.0, 10.0}));
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(1.0), {0.5, 0.3});
  tracker->Follow(At({0.0, 0.0, 12.0}));
  tracker->Follow(At({0.0, 0.0, 10.0})); // 1 mm deep
  EXPECT_LE(std::abs(tracker->Follow(At({0.49, 0.0, 10.0})).ProxyWorld[0]), SkinError);
  EXPECT_NEAR(tracker->Follow(At({0.6, 0.0, 10.0})).ProxyWorld[0], 0.3, SkinError);
}

TEST(FacetTracker, ProxiesAreFiniteAndOutsideForAnyPose)
{
  Random random(6203);
  const RadialModel organ = test::RandomOrgan(random, 6);
  const auto mesh = test::MeshOf(organ, 6);
  const auto tree = test::TreeOf(mesh);
  const auto model = FacetContact(mesh);
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  for (const double radius : {0.0, 2.0})
  {
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(radius));
    for (int tick = 0; tick < 3000; ++tick)
    {
      const double far = std::pow(10.0, static_cast<double>(random() % 5) - 1.0);
      ToolPose pose = At(organ.CenterWorld() + far * test::RandomDirection(random));
      const bool isBad = random() % 50 == 0;
      pose.PositionWorld[2] = isBad ? notANumber : pose.PositionWorld[2];
      const Contact& contact = tracker->Follow(pose);
      ASSERT_EQ(contact.IsValid, !isBad);
      ASSERT_TRUE(contact.ProxyWorld.allFinite());
      ASSERT_NEAR(contact.NormalWorld.norm(), 1.0, 1e-12); // rounding
      if (!isBad)
      {
        ASSERT_FALSE(tree->IsInside(contact.ProxyWorld)) << tick;
        ASSERT_GE(tree->NearestTo(contact.ProxyWorld, 1e9).Distance, radius - SkinError) << tick;
      }
    }
  }
}

TEST(FacetTracker, StartingInsideMovesToTheNearestPlaceOutside)
{
  const auto model = FacetContact(test::BoxMesh({10.0, 10.0, 10.0}));
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(1.0));
  const Contact& contact = tracker->Follow(At({0.0, 8.0, 1.0}));
  ASSERT_TRUE(contact.IsTouching);
  EXPECT_LE((contact.ProxyWorld - Vector3(0.0, 11.0, 1.0)).norm(), SkinError);
}

TEST(FacetContactModel, SupportsSpheresOnly)
{
  const auto model = FacetContact(test::BoxMesh({10.0, 10.0, 10.0}));
  std::unique_ptr<ContactTracker> tracker;
  EXPECT_FALSE(model->MakeTracker(ToolShape::Capsule(1.0, 2.0, 50), {}, tracker).IsOk());
  EXPECT_FALSE(model->MakeTracker(ToolShape::Sphere(1.0), {0.1, 0.2}, tracker).IsOk());
  EXPECT_EQ(tracker, nullptr);
  EXPECT_TRUE(model->BoundsWorld().isApprox({Vector3::Constant(-10.0), Vector3::Constant(10.0)}));
}
} // namespace
} // namespace palpate::facet_tracker_test
