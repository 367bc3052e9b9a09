#include "ContactCases.h"
#include "ContactWedge.h"
#include "NearestByBruteForce.h"
#include "SearchedWedge.h"
#include "SurfacePhantoms.h"
#include "WorstCase.h"

namespace palpate::harmonic_wedge_test
{
namespace
{
using test::At;
using test::RadialContact;
using test::Random;
using test::TrackerOf;
using test::WorstCase;

// A sphere with a groove along the equator, up to 3 mm deep and some 6 mm wide.
RadialModel GroovedSphere()
{
  return test::Project(24, [](const Vector3& u)
                       { return 20.0 - 3.0 * std::exp(-u[2] * u[2] / (0.1 * 0.1)); });
}

std::shared_ptr<const TouchableRadialModel> SurfaceOf(const RadialModel& model)
{
  std::shared_ptr<const TouchableRadialModel> surface;
  EXPECT_TRUE(TouchableRadialModel::Make(test::Shared(model), surface).IsOk());
  return surface;
}

TEST(ContactWedge, IsNeededWhereAHollowIsNarrowerThanTheSphere)
{
  EXPECT_FALSE(ContactWedge::IsNeeded(*SurfaceOf(test::Sphere(20.0)), 100.0));
  const auto grooved = SurfaceOf(GroovedSphere());
  EXPECT_FALSE(ContactWedge::IsNeeded(*grooved, 0.0));
  EXPECT_FALSE(ContactWedge::IsNeeded(*grooved, 0.2));
  EXPECT_TRUE(ContactWedge::IsNeeded(*grooved, 4.0));
}

TEST(ContactWedge, RestsOnBothEdgesOfANarrowGroove)
{
  const RadialModel sphere = GroovedSphere();
  const ClosestPointSearch search(test::Shared(sphere));
  const auto model = RadialContact(sphere);
  constexpr double Radius = 4.0;
  // By symmetry the resting place is on the x axis: there the sphere just touches.
  double rest = 20.0;
  double free = 30.0;
  while (free - rest > 1e-9)
  {
    const double middle = 0.5 * (rest + free);
    (search.Nearest({middle, 0.0, 0.0}).SignedDistance < Radius ? rest : free) = middle;
  }
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(Radius));
  Contact last;
  tracker->Follow(At({30.0, 0.0, 0.3}));
  test::MoveStraight(*tracker, {30.0, 0.0, 0.3}, {rest - 1.5, 0.0, 0.1}, 0.05,
                     [&](const Vector3&, const Contact& contact) { last = contact; });
  ASSERT_TRUE(last.IsTouching);
  EXPECT_LE((last.ProxyWorld - Vector3(rest, 0.0, 0.0)).norm(),
            1e-4); // where steps end: 1e-5 of 1 mm, multiplied by slopes
  EXPECT_NEAR(last.Depth, std::hypot(1.5, 0.1), 1e-4);
}

TEST(ContactWedge, KeepsARoughSurfaceOutsideTheSphere)
{
  Random random(4401);
  for (int body = 0; body < 3; ++body)
  {
    const RadialModel rough = test::RandomRough(random, 12, 20.0);
    const ClosestPointSearch search(test::Shared(rough));
    const auto model = RadialContact(rough);
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(4.0), {0.2, 0.1});
    test::WanderingDirection wandering(random);
    WorstCase overlap;
    for (int tick = 0; tick < 1500; ++tick)
    {
      const Vector3 u = wandering.Next(0.0025);
      const Vector3 probe = rough.PointWorld(u) + (4.0 - 1.0) * rough.Normal(u);
      const Contact& contact = tracker->Follow(At(probe));
      ASSERT_TRUE(contact.IsValid);
      if (tick >= 10) // it starts overlapping
      {
        overlap.Add(std::min(0.0, search.Nearest(contact.ProxyWorld).SignedDistance - 4.0));
      }
    }
    // A new wall is detected up to a step late; a tool moves by less than this per tick.
    EXPECT_LE(overlap.Value(), 0.05);
  }
}

// A hand at 0.2 to 2 m/s, compared with the same path in steps that are twenty times as short.
TEST(ContactWedge, KeepsUpWithAFastHand)
{
  constexpr double Radius = 4.0;
  constexpr int Finer = 20;
  Random random(4402);
  for (const double step : {0.01, 0.035, 0.1}) // rad: 0.2, 0.7 and 2 mm per tick
  {
    const RadialModel rough = test::RandomRough(random, 12, 20.0);
    const auto model = RadialContact(rough);
    const auto fast = TrackerOf(*model, ToolShape::Sphere(Radius));
    const auto slow = TrackerOf(*model, ToolShape::Sphere(Radius));
    test::WanderingDirection wandering(random);
    Vector3 last = 2.0 * rough.PointWorld(wandering.Next(0.0)) - rough.CenterWorld();
    fast->Follow(At(last));
    slow->Follow(At(last));
    int late = 0;
    for (int tick = 0; tick < 200; ++tick)
    {
      const Vector3 u = wandering.Next(step);
      const Vector3 probe = rough.PointWorld(u) + (Radius - 1.5) * rough.Normal(u);
      Contact fine;
      for (int part = 1; part <= Finer; ++part)
      {
        fine = slow->Follow(At(last + part * (probe - last) / Finer));
      }
      const Contact& coarse = fast->Follow(At(probe));
      ASSERT_TRUE(coarse.IsValid);
      // Long steps may end in another resting place of the sphere, which is no farther than a
      // hollow is wide, or a few ticks late; a sphere that lags falls back by a step per tick.
      const double farther = (coarse.ProxyWorld - probe).norm() - (fine.ProxyWorld - probe).norm();
      late = farther > Radius ? late + 1 : 0;
      if (tick >= 10)
      {
        EXPECT_LE(late, 5) << step << ' ' << tick;
      }
      last = probe;
    }
  }
}

class ContactWedgeOfDegree : public testing::TestWithParam<int>
{
};

TEST_P(ContactWedgeOfDegree, EqualsASearchOfTheWholeSurface)
{
  constexpr double Radius = 6.0;
  Random random(static_cast<unsigned>(4410 + GetParam()));
  const RadialModel rough = GetParam() < 20 ? test::RandomRough(random, GetParam(), 20.0)
                                            : test::RandomOrgan(random, GetParam());
  const auto surface = SurfaceOf(rough);
  ContactWedge wedge(surface, Radius);
  test::SearchedWedge oracle(surface, Radius);
  test::WanderingDirection wandering(random);
  WorstCase overlap;
  int apart = 0;
  double deeper = 0.0;
  constexpr int Ticks = 400;
  for (int tick = 0; tick < Ticks; ++tick)
  {
    const Vector3 u = wandering.Next(0.0025);
    const double height = Radius - std::min(1.0, 0.05 * tick);
    const Vector3 probe = rough.PointWorld(u) + height * rough.Normal(u);
    if (tick == 0)
    {
      const ClosestPoint nearest = surface->Search().Nearest(probe);
      wedge.Begin(nearest);
      oracle.Begin(nearest.PointWorld + Radius * nearest.Normal);
    }
    wedge.MoveTo(probe);
    oracle.MoveTo(probe);
    const Vector3& place = wedge.CenterWorld();
    if (tick >= 20) // both begin overlapping
    {
      overlap.Add(std::min(0.0, surface->Search().Nearest(place, 20000).SignedDistance - Radius));
      // Both end where a step is 1e-5 of the radius; slopes increase that.
      apart += (place - oracle.CenterWorld()).norm() > 1e-3 ? 1 : 0;
      deeper += (place - probe).norm() - (oracle.CenterWorld() - probe).norm();
    }
  }
  EXPECT_LE(overlap.Value(), 1.1e-5 * surface->SmallestRadius() + 1e-4); // a proof's tolerance
  EXPECT_LE(apart, Ticks / 20);                                          // another exit was found
  EXPECT_LE(deeper / Ticks, 1e-3);
}

// Where a tool comes to a surface by a jump, nothing is proven there yet, and hundreds of cells are
// near a large sphere. What was free before the step is enough to go on.
TEST(ContactWedge, GoesOnFromAFreePlaceWhereAProofTakesMoreThanATick)
{
  constexpr double Radius = 60.0; // mm
  constexpr double Step = 0.05;   // mm, from where it touches, to either side
  Random random(5);
  const SurfaceModel body = test::BumpyTube(random);
  std::shared_ptr<const TouchableSurfaceModel> surface;
  ASSERT_TRUE(TouchableSurfaceModel::Make(body, surface).IsOk());
  ContactWedgeOf<TouchableSurfaceModel> wedge(surface, Radius);
  WorstCase error;
  for (int jump = 0; jump < 400; ++jump)
  {
    const auto foot = surface->PlaceAt(test::RandomDirection(random));
    const auto near = [&](double height)
    { return surface->Search().Nearest(foot.PointWorld + height * foot.Normal, 20000); };
    const Vector3 free = foot.PointWorld + (Radius + Step) * foot.Normal;
    const Vector3 aside = Step * foot.Normal.unitOrthogonal();
    const Vector3 goal = free - 2.0 * Step * foot.Normal + aside;
    const auto wall = surface->Search().Nearest(goal, 20000);
    const Vector3 place = wall.PointWorld + Radius * wall.Normal;
    const bool isAlone = surface->Search().Nearest(place, 20000).SignedDistance > Radius - 1e-9;
    if (near(Radius + Step).SignedDistance > Radius && wall.SignedDistance < Radius && isAlone)
    {
      wedge.Begin(near(Radius + Step), {free, Radius});
      wedge.MoveTo(goal);
      error.Add((wedge.CenterWorld() - place).norm());
    }
  }
  // A wall may be unknown as deep as a proof's tolerance, a thousandth of 7 mm.
  EXPECT_LE(error.Value(), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Each, ContactWedgeOfDegree, testing::Values(4, 8, 12, 20, 33));
} // namespace
} // namespace palpate::harmonic_wedge_test
