#include "ContactCases.h"
#include "NearestByBruteForce.h"
#include "WorstCase.h"

#include <limits>

namespace palpate::harmonic_nearest_tracker_test
{
namespace
{
using test::At;
using test::RadialContact;
using test::Random;
using test::TrackerOf;
using test::WanderingDirection;
using test::WorstCase;

// Tracking tolerance of a minimum on an organ (mm): the angle 1e-7 times 20 mm or so, which steep
// places double.
constexpr double TrackingError = 1e-5;

TEST(NearestPointTracker, ProxyOnASphereIsRadial)
{
  Random random(4101);
  const Vector3 center(30.0, -80.0, 12.0);
  const auto model = RadialContact(test::Sphere(20.0, center));
  for (const double toolRadius : {0.0, 0.5, 5.0, 50.0})
  {
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius));
    WanderingDirection wandering(random);
    WorstCase error;
    for (int tick = 0; tick < 2000; ++tick)
    {
      const Vector3 u = wandering.Next(0.0025);
      const double height = 20.0 + toolRadius + 1.5 * std::sin(0.01 * tick);
      const Contact& contact = tracker->Follow(At(center + height * u));
      const double depth = 20.0 + toolRadius - height;
      ASSERT_TRUE(contact.IsValid);
      ASSERT_EQ(contact.IsTouching, depth > 1e-9) << depth; // 1e-9: at the start depth is rounding
      if (contact.IsTouching)
      {
        error.Add((contact.ProxyWorld - (center + (20.0 + toolRadius) * u)).norm());
        error.Add((contact.NormalWorld - u).norm() * 20.0);
        error.Add(contact.Depth - depth);
      }
      else
      {
        ASSERT_EQ(contact.ProxyWorld, Vector3(center + height * u));
      }
    }
    EXPECT_LE(error.Value(), TrackingError * (1.0 + toolRadius / 20.0)) << toolRadius;
  }
}

TEST(NearestPointTracker, ProxyOnOrgansIsNearestAlongServoPaths)
{
  Random random(4102);
  for (int body = 0; body < 4; ++body)
  {
    const RadialModel organ = test::RandomOrgan(random, 12);
    const ClosestPointSearch search(test::Shared(organ));
    const auto model = RadialContact(organ);
    for (const double toolRadius : {0.0, 1.0, 4.0})
    {
      const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius));
      WanderingDirection wandering(random);
      WorstCase error;
      for (int tick = 0; tick < 1000; ++tick)
      {
        // 50 mm/s at 1 kHz, 1.5 mm deep.
        const Vector3 u = wandering.Next(0.0025);
        const Vector3 probe = organ.PointWorld(u) + (toolRadius - 1.5) * organ.Normal(u);
        const Contact& contact = tracker->Follow(At(probe));
        ASSERT_TRUE(contact.IsTouching);
        const ClosestPoint nearest = search.Nearest(probe);
        error.Add((contact.ProxyWorld - nearest.PointWorld - toolRadius * nearest.Normal).norm());
      }
      // Normals turn by up to 1 rad in 2 mm of these organs, which multiplies a tool's radius.
      EXPECT_LE(error.Value(), TrackingError * (1.0 + 0.5 * toolRadius)) << toolRadius;
    }
  }
}

TEST(NearestPointTracker, ContactBeginsAndEndsAtTheSurface)
{
  Random random(4103);
  const RadialModel organ = test::RandomOrgan(random, 12);
  const ClosestPointSearch search(test::Shared(organ));
  const auto model = RadialContact(organ);
  int changes = 0;
  for (int path = 0; path < 200; ++path)
  {
    const double toolRadius = path % 3;
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius));
    const Vector3 u = test::RandomDirection(random);
    const Vector3 inside = organ.PointWorld(u) - organ.Normal(u);
    const Vector3 outside =
        organ.PointWorld(u) + (toolRadius + 2.0) * organ.Normal(u) + test::RandomDirection(random);
    tracker->Follow(At(outside));
    bool wasTouching = false;
    const auto check = [&](const Vector3& probe, const Contact& contact)
    {
      const double distance = search.Nearest(probe).SignedDistance - toolRadius;
      if (std::abs(distance) > 1e-4) // the tracker's gap, 1e-6 of the radius, is far below
      {
        EXPECT_EQ(contact.IsTouching, distance < 0.0) << distance;
      }
      changes += contact.IsTouching != wasTouching ? 1 : 0;
      wasTouching = contact.IsTouching;
    };
    test::MoveStraight(*tracker, outside, inside, 0.05, check);
    test::MoveStraight(*tracker, inside, outside, 0.05, check);
  }
  EXPECT_EQ(changes, 400); // in and out once on each path
}

TEST(NearestPointTracker, PassesThroughNothingAtAnySpeed)
{
  Random random(4104);
  // A pancake 1 mm thick: its half axes in mm.
  const RadialModel pancake = test::Ellipsoid({4.0, 4.0, 0.5}, Matrix3::Identity(), 24);
  const auto model = RadialContact(pancake);
  for (const double toolRadius : {0.0, 0.2, 3.0})
  {
    for (const double step : {0.1, 1.0, 10.0, 100.0}) // mm per tick: up to 100 m/s at 1 kHz
    {
      const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius));
      const Vector3 across = 0.5 * test::RandomDirection(random);
      const Vector3 above = Vector3(0.0, 0.0, 57.0) + across;
      const Vector3 beyond = Vector3(0.0, 0.0, -0.6 - toolRadius) - across;
      tracker->Follow(At(above));
      Contact last;
      test::MoveStraight(*tracker, above, beyond, step,
                         [&](const Vector3&, const Contact& contact) { last = contact; });
      ASSERT_TRUE(last.IsTouching) << toolRadius << " " << step;
      EXPECT_GT(last.ProxyWorld[2], 0.0) << toolRadius << " " << step;
      EXPECT_GT(last.NormalWorld[2], 0.0);
    }
  }
}

TEST(NearestPointTracker, ProxiesStayOutsideOnRandomFlights)
{
  Random random(4105);
  const RadialModel organ = test::RandomOrgan(random, 12);
  const ClosestPointSearch search(test::Shared(organ));
  const auto model = RadialContact(organ);
  std::uniform_real_distribution<double> speed(-2.0, 2.0); // 10^ mm per tick
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.0));
  Vector3 probe = organ.CenterWorld() + Vector3(60.0, 0.0, 0.0);
  WorstCase inside;
  for (int tick = 0; tick < 5000; ++tick)
  {
    const Vector3 goal = organ.CenterWorld() + 40.0 * test::RandomDirection(random);
    probe += std::min(1.0, std::pow(10.0, speed(random)) / (goal - probe).norm()) * (goal - probe);
    const Contact& contact = tracker->Follow(At(probe));
    ASSERT_TRUE(contact.IsValid);
    if (contact.IsTouching)
    {
      inside.Add(std::min(0.0, search.Nearest(contact.ProxyWorld).SignedDistance));
      ASSERT_NEAR(contact.NormalWorld.norm(), 1.0, 1e-12); // rounding
    }
    else
    {
      ASSERT_GE(search.Nearest(probe).SignedDistance, -1e-9); // rounding
    }
  }
  EXPECT_LE(inside.Value(), TrackingError);
}

TEST(NearestPointTracker, ProxyStaysOnTheSurfaceThroughASpheresCentre)
{
  const auto model = RadialContact(test::Sphere(20.0));
  for (const double aside : {0.0, 1e-9, 1e-3, 0.5}) // mm
  {
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(1.0));
    const Vector3 start(aside, 0.0, 25.0);
    tracker->Follow(At(start));
    Vector3 proxy = start;
    bool isInFullContact = false;
    int touched = 0;
    WorstCase jump;
    test::MoveStraight(*tracker, start, Vector3(aside, 0.0, -25.0), 0.1,
                       [&](const Vector3& probe, const Contact& contact)
                       {
                         ASSERT_TRUE(contact.IsValid);
                         jump.Add(contact.IsTouching || isInFullContact
                                      ? (contact.ProxyWorld - proxy).norm()
                                      : 0.0);
                         proxy = contact.ProxyWorld;
                         isInFullContact = contact.IsTouching;
                         touched += contact.IsTouching ? 1 : 0;
                         if (contact.IsTouching)
                         {
                           ASSERT_NEAR(proxy.norm(), 21.0, 1e-9); // rounding
                         }
                       });
    EXPECT_FALSE(isInFullContact);
    EXPECT_GE(touched, 415); // 42 mm long
    // 0.1 rad and 2 * 0.1 / 20 more are allowed per tick, at 21 mm.
    EXPECT_LE(jump.Value(), 21.0 * 0.111) << aside;
  }
}

TEST(NearestPointTracker, IsIndependentOfTheUnitOfLength)
{
  for (const double scale : {1e-3, 1.0, 1e3})
  {
    Random random(4106);
    const RadialModel organ = test::RandomOrgan(random, 12);
    std::vector<double> scaled = organ.Coefficients();
    for (double& c : scaled)
    {
      c *= scale;
    }
    const auto small = RadialContact(organ);
    const auto large = RadialContact({12, scaled, scale * organ.CenterWorld()});
    const SurfaceFriction friction{0.3, 0.2};
    const auto here = TrackerOf(*small, ToolShape::Sphere(1.0), friction);
    const auto there = TrackerOf(*large, ToolShape::Sphere(scale), friction);
    WanderingDirection wandering(random);
    WorstCase difference;
    for (int tick = 0; tick < 1000; ++tick)
    {
      const Vector3 u = wandering.Next(0.005);
      const Vector3 probe =
          organ.PointWorld(u) + (1.0 + 1.5 * std::sin(0.02 * tick)) * organ.Normal(u);
      const Contact& one = here->Follow(At(probe));
      const Contact& other = there->Follow(At(scale * probe));
      ASSERT_EQ(one.IsTouching, other.IsTouching) << tick;
      difference.Add((one.ProxyWorld - other.ProxyWorld / scale).norm());
      difference.Add(one.Depth - other.Depth / scale);
    }
    // Slips end within 1e-6 of a pull of about 1 mm, and the ends of paths differ by roundings.
    EXPECT_LE(difference.Value(), 1e-5) << scale;
  }
}

TEST(NearestPointTracker, HandlesSpecialPlaces)
{
  Random random(4107);
  const RadialModel organ = test::RandomOrgan(random, 12);
  const Vector3 center = organ.CenterWorld();
  const auto model = RadialContact(organ);
  std::vector<Vector3> places{center, center + Vector3(0.0, 0.0, 10.0),
                              center - Vector3(0.0, 0.0, 10.0), center + Vector3(1e4, 0.0, 0.0),
                              center + Vector3::Constant(1e90)};
  for (const Vector3& u : {Vector3(0, 0, 1), Vector3(0, 0, -1), Vector3(1, 0, 0)})
  {
    places.push_back(organ.PointWorld(u));
    places.push_back(organ.PointWorld(u) * (1.0 + 1e-16));
    places.push_back(organ.PointWorld(u) + Vector3::Constant(5e-324));
  }
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.5));
  for (int tick = 0; tick < 2000; ++tick)
  {
    const Contact& contact = tracker->Follow(At(places[random() % places.size()]));
    ASSERT_TRUE(contact.IsValid);
    ASSERT_TRUE(contact.ProxyWorld.allFinite());
    ASSERT_NEAR(contact.NormalWorld.norm(), 1.0, 1e-12); // rounding
    ASSERT_TRUE(std::isfinite(contact.Depth));
    if (random() % 4 == 0)
    {
      tracker->Release();
    }
  }
}

TEST(NearestPointTracker, InvalidPoseHasNoContactAndKeepsTheProxy)
{
  constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
  constexpr double Infinite = std::numeric_limits<double>::infinity();
  const auto model = RadialContact(test::Sphere(20.0));
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.0));
  tracker->Follow(At({0.0, 0.0, 30.0}));
  const Contact before = tracker->Follow(At({0.0, 0.0, 19.0}));
  ASSERT_TRUE(before.IsTouching);
  ToolPose turned = At({0.0, 0.0, 19.0});
  turned.Orientation.x() = NotANumber;
  for (const ToolPose& pose :
       {At({NotANumber, 0.0, 19.0}), At({0.0, Infinite, 0.0}), At({0.0, 0.0, 1e200}), turned})
  {
    const Contact& contact = tracker->Follow(pose);
    EXPECT_FALSE(contact.IsValid);
    EXPECT_FALSE(contact.IsTouching);
  }
  const Contact& after = tracker->Follow(At({0.0, 0.0, 19.0}));
  EXPECT_TRUE(after.IsTouching);
  EXPECT_LE((after.ProxyWorld - before.ProxyWorld).norm(), 1e-12); // rounding
}

TEST(NearestPointTracker, RestartsAnywhereAfterRelease)
{
  const auto model = RadialContact(test::Sphere(20.0));
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.0));
  tracker->Follow(At({0.0, 0.0, 30.0}));
  ASSERT_TRUE(tracker->Follow(At({0.0, 0.0, 18.0})).IsTouching);
  tracker->Release();
  const Contact& fresh = tracker->Follow(At({0.0, -18.0, 0.0}));
  ASSERT_TRUE(fresh.IsTouching);
  EXPECT_LE((fresh.ProxyWorld - Vector3(0.0, -20.0, 0.0)).norm(), TrackingError);
}
} // namespace
} // namespace palpate::harmonic_nearest_tracker_test
