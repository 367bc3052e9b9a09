#include "ClosestPointSearch.h"
#include "ContactCases.h"
#include "FrictionCone.h"
#include "WorstCase.h"

#include <limits>

namespace palpate::harmonic_friction_test
{
namespace
{
using test::At;
using test::RadialContact;
using test::Random;
using test::TrackerOf;
using test::WorstCase;

constexpr SurfaceFriction Rough{0.5, 0.3};

// The probe's pull on its proxy.
FrictionCone::Pull PullOf(const Vector3& probe, const Contact& contact)
{
  return {probe - contact.ProxyWorld, contact.NormalWorld};
}

TEST(RadialFriction, SticksWithinTheCone)
{
  for (const double toolRadius : {0.0, 3.0})
  {
    const auto model = RadialContact(test::Sphere(20.0));
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius), Rough);
    const double top = 20.0 + toolRadius;
    tracker->Follow(At({0.0, 0.0, top + 1.0}));
    const Contact down = tracker->Follow(At({0.0, 0.0, top - 1.0}));
    for (int tick = 0; tick < 200; ++tick)
    {
      const double angle = 0.1 * tick;
      const double reach = 0.499; // of a pull of 1 mm into the surface
      const Vector3 probe(reach * std::cos(angle), reach * std::sin(angle), top - 1.0);
      const Contact& contact = tracker->Follow(At(probe));
      ASSERT_TRUE(contact.IsTouching);
      EXPECT_EQ(contact.ProxyWorld, down.ProxyWorld);
    }
    EXPECT_LE((down.ProxyWorld - Vector3(0.0, 0.0, top)).norm(), 1e-9); // straight down: rounding
    EXPECT_NE(tracker->Follow(At({0.501, 0.0, top - 1.0})).ProxyWorld, down.ProxyWorld);
  }
}

TEST(RadialFriction, SlipsUntilTheDynamicCone)
{
  Random random(4201);
  const RadialModel organ = test::RandomOrgan(random, 12);
  const auto model = RadialContact(organ);
  WorstCase excess;
  int slips = 0;
  for (const double toolRadius : {0.0, 2.0})
  {
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius), Rough);
    test::WanderingDirection wandering(random);
    Vector3 before = Vector3::Zero();
    for (int tick = 0; tick < 3000; ++tick)
    {
      const Vector3 u = wandering.Next(0.0025);
      const Vector3 probe = organ.PointWorld(u) + (toolRadius - 1.0) * organ.Normal(u);
      const Contact& contact = tracker->Follow(At(probe));
      ASSERT_TRUE(contact.IsTouching);
      const FrictionCone::Pull pull = PullOf(probe, contact);
      if (contact.ProxyWorld != before)
      {
        slips += tick > 0 ? 1 : 0;
        excess.Add(tick > 0 ? FrictionCone(Rough).Excess(pull) / pull.Along : 0.0);
      }
      EXPECT_TRUE(FrictionCone(Rough).Sticks(pull));
      before = contact.ProxyWorld;
    }
  }
  EXPECT_GT(slips, 20);
  EXPECT_LE(excess.Value(), 1.1e-6); // tolerance of the search for the resting place
}

TEST(RadialFriction, ProxyStaysOnTheSurfaceAndLeavesWithTheProbe)
{
  Random random(4202);
  const RadialModel organ = test::RandomOrgan(random, 12);
  const ClosestPointSearch search(test::Shared(organ));
  const auto model = RadialContact(organ);
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(1.0), Rough);
  test::WanderingDirection wandering(random);
  WorstCase offset;
  for (int tick = 0; tick < 3000; ++tick)
  {
    const Vector3 u = wandering.Next(0.0025);
    const Vector3 probe =
        organ.PointWorld(u) + (1.0 + 1.5 * std::sin(0.02 * tick)) * organ.Normal(u);
    const Contact& contact = tracker->Follow(At(probe));
    const double distance = search.Nearest(probe).SignedDistance - 1.0;
    if (std::abs(distance) > 1e-4) // the tracker's gap, 1e-6 of the radius, is far below
    {
      ASSERT_EQ(contact.IsTouching, distance < 0.0);
    }
    if (contact.IsTouching)
    {
      offset.Add(search.Nearest(contact.ProxyWorld).SignedDistance - 1.0);
    }
  }
  EXPECT_LE(offset.Value(), 1e-9); // of a place on the surface: rounding
}

TEST(RadialFriction, NoTangentialForceWithoutFriction)
{
  Random random(4203);
  const RadialModel organ = test::RandomOrgan(random, 12);
  const auto model = RadialContact(organ);
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(1.0));
  test::WanderingDirection wandering(random);
  WorstCase along;
  for (int tick = 0; tick < 1000; ++tick)
  {
    const Vector3 u = wandering.Next(0.0025);
    const Vector3 probe = organ.PointWorld(u) - 0.5 * organ.Normal(u);
    along.Add(PullOf(probe, tracker->Follow(At(probe))).Along);
  }
  EXPECT_LE(along.Value(), 1e-5); // of tracking: the angle 1e-7 times some 20 mm, doubled
}

TEST(RadialFriction, RejectsInvalidFriction)
{
  constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
  const auto model = RadialContact(test::Sphere(20.0));
  for (const SurfaceFriction& friction :
       {SurfaceFriction{-0.1, -0.1}, SurfaceFriction{0.2, 0.3}, SurfaceFriction{0.2, -0.1},
        SurfaceFriction{NotANumber, 0.1}, SurfaceFriction{0.2, NotANumber}})
  {
    std::unique_ptr<ContactTracker> tracker;
    EXPECT_FALSE(model->MakeTracker(ToolShape::Sphere(1.0), friction, tracker).IsOk());
    EXPECT_EQ(tracker, nullptr);
  }
}
} // namespace
} // namespace palpate::harmonic_friction_test
