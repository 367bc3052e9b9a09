#include "ClosestPointSearch.h"
#include "ContactCases.h"
#include "OrganContact.h"
#include "SimplePhantoms.h"
#include "SurfaceModelPath.h"
#include "SurfacePhantoms.h"
#include "SurfaceTessellation.h"
#include "TouchableSurfaceModel.h"
#include "WedgePlaces.h"
#include "WindingMesh.h"
#include "WorstCase.h"

#include <algorithm>
#include <limits>

namespace palpate::parametric_contact_model_test
{
namespace
{
using test::At;
using test::Random;
using test::TrackerOf;
using test::WorstCase;

constexpr double Stiffness = 0.5; // N/mm

std::shared_ptr<const ContactModel> SurfaceContact(const SurfaceModel& surface)
{
  std::shared_ptr<const ContactModel> contact;
  const Status status = MakeOrganContact(surface, contact);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return contact;
}

// The point of an ellipsoid around the origin nearest to a point, which must be nearer to the
// surface than to the medial axis: on the normal through it, found by bisection.
Vector3 NearestOnEllipsoid(const Vector3& axes, const Vector3& point)
{
  const Vector3 squares = axes.cwiseProduct(axes);
  const auto at = [&](double t)
  { return Vector3(squares.cwiseProduct(point).cwiseQuotient(squares + Vector3::Constant(t))); };
  double low = -squares.minCoeff();
  double high = 100.0 * squares.maxCoeff();
  for (int i = 0; i < 200; ++i)
  {
    const double middle = 0.5 * (low + high);
    (at(middle).cwiseQuotient(axes).squaredNorm() > 1.0 ? low : high) = middle;
  }
  return at(0.5 * (low + high));
}

TEST(SurfaceModelContact, ForcesOfAnEllipsoidAreExact)
{
  const Vector3 axes(25.0, 20.0, 16.0);
  const SurfaceModel surface = test::EllipsoidPhantom(axes, 8);
  const Vector3 center = surface.Point(Vector3::UnitX()) - Vector3(axes[0], 0.0, 0.0);
  const auto model = SurfaceContact(surface);
  for (const double toolRadius : {0.0, 1.0, 4.0})
  {
    Random random(9101);
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius));
    WorstCase error;
    int touches = 0;
    for (int path = 0; path < 300; ++path)
    {
      tracker->Release();
      test::FollowSurfacePath(
          surface, toolRadius, random,
          [&](const Vector3& probe)
          {
            const Contact& contact = tracker->Follow(At(probe));
            const Vector3 foot = NearestOnEllipsoid(axes, probe - center);
            const Vector3 normal = foot.cwiseQuotient(axes).cwiseQuotient(axes).normalized();
            const bool isTouched = (probe - center - foot).dot(normal) < toolRadius;
            const Vector3 ideal = isTouched ? Vector3(center + foot + toolRadius * normal) : probe;
            error.Add(Stiffness * (contact.ProxyWorld - ideal).norm());
            touches += contact.IsTouching ? 1 : 0;
          });
    }
    EXPECT_GT(touches, 300 * 24);
    EXPECT_LE(error.Value(), 1e-9) << toolRadius; // N, the required accuracy
  }
}

TEST(SurfaceModelContact, ForcesEqualThoseOfTheRadialModel)
{
  Random random(9102);
  const RadialModel organ = test::RandomOrgan(random, 8);
  const SurfaceModel surface = SurfaceModel::FromModel(organ);
  const auto star = test::RadialContact(organ);
  const auto mapped = SurfaceContact(surface);
  for (const double toolRadius : {0.0, 1.0})
  {
    const auto one = TrackerOf(*star, ToolShape::Sphere(toolRadius));
    const auto other = TrackerOf(*mapped, ToolShape::Sphere(toolRadius));
    WorstCase difference;
    for (int path = 0; path < 300; ++path)
    {
      one->Release();
      other->Release();
      test::FollowSurfacePath(
          surface, toolRadius, random,
          [&](const Vector3& probe)
          {
            difference.Add(
                Stiffness *
                (one->Follow(At(probe)).ProxyWorld - other->Follow(At(probe)).ProxyWorld).norm());
          });
    }
    RecordProperty("newtons", std::to_string(difference.Value()));
    EXPECT_LE(difference.Value(), 1e-9) << toolRadius;
  }
}

// A proxy at a farther point is one that keeps to the minimum that it met.
TEST(SurfaceModelContact, ProxiesAreAtTheNearestPoint)
{
  for (const auto& [name, surface] : test::SimplePhantoms())
  {
    SCOPED_TRACE(name);
    const auto model = SurfaceContact(surface);
    const ClosestPointSearchOf<CenteredSurface> search(
        std::make_shared<const CenteredSurface>(surface));
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.0));
    Random random(9103);
    WorstCase farther;
    int others = 0;
    for (int path = 0; path < 150; ++path)
    {
      tracker->Release();
      test::FollowSurfacePath(surface, 0.0, random,
                              [&](const Vector3& probe)
                              {
                                const Contact& contact = tracker->Follow(At(probe));
                                const auto nearest = search.Nearest(probe);
                                ASSERT_EQ(contact.IsTouching, nearest.SignedDistance < 0.0);
                                const Vector3 ideal =
                                    contact.IsTouching ? nearest.PointWorld : probe;
                                const double error = (contact.ProxyWorld - ideal).norm();
                                const bool isOther =
                                    contact.Depth > std::abs(nearest.SignedDistance) + 1e-6;
                                others += isOther ? 1 : 0;
                                farther.Add(isOther ? 0.0 : Stiffness * error);
                              });
    }
    EXPECT_LE(farther.Value(), 1e-9);
    EXPECT_LE(others, 150 * 28 / 5); // the bowl's wall is thinner than the depth near its rim
  }
}

// A tool that begins outside of a surface that does not cross itself is never inside without
// contact, however it moves: slowly over the surface, in and out, or 5 mm in a tick.
TEST(SurfaceModelContact, NoToolIsInsideWithoutContact)
{
  for (const auto& [name, surface] : test::SimplePhantoms())
  {
    SCOPED_TRACE(name);
    const auto model = SurfaceContact(surface);
    const ClosestPointSearchOf<CenteredSurface> search(
        std::make_shared<const CenteredSurface>(surface));
    for (const double toolRadius : {0.0, 1.0})
    {
      Random random(9107);
      std::uniform_real_distribution<double> uniform(0.0, 1.0);
      const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius));
      Vector3 parameter = test::RandomDirection(random);
      Vector3 jump = Vector3::Zero();
      int inside = 0;
      int outsideButTouching = 0;
      int touches = 0;
      int leaves = 0;
      bool wasTouching = false;
      tracker->Follow(At(model->BoundsWorld().max() + Vector3::Ones()));
      for (int tick = 0; tick < 3000; ++tick)
      {
        parameter = (parameter + 0.004 * test::RandomDirection(random)).normalized();
        jump = uniform(random) < 0.01 ? Vector3(5.0 * test::RandomDirection(random))
                                      : Vector3(0.9 * jump);
        const double height = 0.3 * std::sin(0.13 * tick) + 0.1 * std::sin(1.7 * tick);
        const Vector3 probe =
            surface.Point(parameter) + (toolRadius + height) * surface.Normal(parameter) + jump;
        const Contact& contact = tracker->Follow(At(probe));
        const auto nearest = search.Nearest(probe, 5000);
        constexpr double Slack = 3e-5; // mm, more than the gap that counts as contact
        inside += !contact.IsTouching && nearest.SignedDistance < toolRadius - Slack ? 1 : 0;
        const auto proxy = search.Nearest(contact.ProxyWorld, 5000);
        outsideButTouching += proxy.SignedDistance < toolRadius - Slack ? 1 : 0;
        touches += contact.IsTouching ? 1 : 0;
        leaves += wasTouching && !contact.IsTouching ? 1 : 0;
        wasTouching = contact.IsTouching;
      }
      EXPECT_EQ(inside, 0) << toolRadius;
      EXPECT_EQ(outsideButTouching, 0) << toolRadius;
      EXPECT_GT(touches, 300);
      EXPECT_GT(leaves, 50);
    }
  }
}

// A tool that was pressed through a sheet: inside as seen from the wall that it met, beyond the
// other one. It is pushed out there, not back in.
TEST(TouchableSurfaceModel, OtherWallsAreSeenFromOutsideToo)
{
  std::shared_ptr<const TouchableSurfaceModel> surface;
  ASSERT_TRUE(TouchableSurfaceModel::Make(test::Bowl(), surface).IsOk());
  const auto& search = surface->Search();
  const auto met = search.Nearest(Vector3(-25.0, 0.0, 10.0 + 24.5));
  const Vector3 beyond(-25.0, 0.0, 10.0 + 15.5);
  const auto other = search.Nearest(beyond);
  ASSERT_GT(other.SignedDistance, 0.0);
  ASSERT_LT(other.Normal.dot(met.Normal), -0.9);
  const auto pressed = search.Track(beyond, met);
  ASSERT_LT(pressed.SignedDistance, 0.0);
  const auto seen = surface->SeenLike(pressed, other);
  EXPECT_EQ(seen.SignedDistance, other.SignedDistance);
  EXPECT_EQ(seen.Normal, other.Normal);
}

// The mesh has the resolution of the one that decides where the surface crosses itself.
WindingMesh MeshOf(const SurfaceModel& surface)
{
  const IndexedMesh mesh = Tessellated(surface, IcosahedronDirections(2 * surface.Degree()));
  return {mesh.Points, mesh.Triangles};
}

TEST(SurfaceModelContact, ProxyStaysOutOfASurfaceThatCrossesItself)
{
  const SurfaceModel surface = test::CrossingRing();
  const WindingMesh mesh = MeshOf(surface);
  const auto model = SurfaceContact(surface);
  // The two ends meet opposite the middle of the tube.
  const Vector3 seam(5.0 - 20.0, 60.0, -30.0);
  constexpr double Off = 0.1; // mm, more than the mesh's deviation
  for (const double toolRadius : {0.0, 1.0})
  {
    Random random(9104);
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(toolRadius), {0.3, 0.2});
    test::WanderingDirection wandering(random);
    int inside = 0;
    int touches = 0;
    WorstCase jump;
    Vector3 last = tracker->Follow(At(seam + 30.0 * wandering.Current())).ProxyWorld;
    for (int tick = 0; tick < 4000; ++tick)
    {
      const double away = 7.0 + 7.0 * std::cos(0.01 * tick);
      const Contact& contact = tracker->Follow(At(seam + away * wandering.Next(0.005)));
      ASSERT_TRUE(contact.ProxyWorld.allFinite());
      const Vector3 place = contact.ProxyWorld + Off * contact.NormalWorld;
      inside += contact.IsTouching && mesh.WindingNumber(place) != 0 ? 1 : 0;
      touches += contact.IsTouching ? 1 : 0;
      jump.Add((contact.ProxyWorld - last).norm());
      last = contact.ProxyWorld;
    }
    EXPECT_EQ(inside, 0) << toolRadius;
    EXPECT_GT(touches, 500);
  }
}

TEST(SurfaceModelContact, StaysFiniteWhateverTheProbeDoes)
{
  Random random(9105);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<test::NamedPhantom> phantoms = test::SimplePhantoms();
  phantoms.push_back({"CrossingRing", test::CrossingRing()});
  for (const auto& [name, surface] : phantoms)
  {
    const auto model = SurfaceContact(surface);
    const auto bounds = model->BoundsWorld();
    const double largest = bounds.diagonal().norm();
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.5), {0.4, 0.3});
    Vector3 probe = bounds.center();
    for (int tick = 0; tick < 1500; ++tick)
    {
      const bool isJump = uniform(random) < 0.02;
      probe =
          isJump
              ? Vector3(bounds.center() + uniform(random) * largest * test::RandomDirection(random))
              : Vector3(probe + 0.3 * test::RandomDirection(random));
      const Contact& contact = tracker->Follow(At(probe));
      ASSERT_TRUE(contact.IsValid);
      ASSERT_TRUE(contact.ProxyWorld.allFinite() && contact.NormalWorld.allFinite()) << name;
      ASSERT_LE((contact.ProxyWorld - bounds.center()).norm(), 2.0 * largest) << name;
    }
    const Vector3 nowhere = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(tracker->Follow(At(nowhere)).IsValid);
    EXPECT_TRUE(tracker->Follow(At(probe)).IsValid);
  }
}

// Work that a tick has no time for must not delay the next contact: down to the surface and up
// again at 0.1 m/s, with a turn along it in between.
TEST(SurfaceModelContact, MeetsTheSurfaceInTime)
{
  for (const auto& [name, surface] : test::SimplePhantoms())
  {
    Random random(9111);
    const auto model = SurfaceContact(surface);
    const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.0));
    Vector3 parameter = test::RandomDirection(random);
    int late = 0;
    for (int tick = 0; tick < 20000; ++tick)
    {
      const Vector3 axis = parameter.cross(test::RandomDirection(random)).normalized();
      parameter = (Eigen::AngleAxisd(0.002, axis) * parameter).normalized();
      const double height = 2.0 * std::sin(0.05 * tick);
      const Contact& contact =
          tracker->Follow(At(surface.Point(parameter) + height * surface.Normal(parameter)));
      late = height < 0.0 && !contact.IsTouching ? late + 1 : 0;
      ASSERT_LE(late, 4) << name << " " << tick;
    }
  }
}

TEST(SurfaceModelContact, FrictionHoldsTheProxy)
{
  const SurfaceModel surface = test::OpenRing();
  const auto model = SurfaceContact(surface);
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.0), {0.5, 0.4});
  const Vector3 parameter = Vector3(0.8, 0.5, 0.3).normalized();
  const Vector3 place = surface.Point(parameter);
  const Vector3 normal = surface.Normal(parameter);
  const Vector3 along = normal.unitOrthogonal();
  test::MoveStraight(*tracker, place + normal, place - normal, 0.05,
                     [](const Vector3&, const Contact&) {});
  // Within the cone of 0.5 mm around the pull of 1 mm.
  const Contact& stuck = tracker->Follow(At(place - normal + 0.4 * along));
  EXPECT_LE((stuck.ProxyWorld - place).norm(), 0.02); // where contact began
  const Contact& slipped = tracker->Follow(At(place - normal + 0.8 * along));
  EXPECT_GT((slipped.ProxyWorld - place).norm(), 0.2);
}

TEST(SurfaceModelContact, TurnsASurfaceThatIsInsideOut)
{
  const SurfaceModel bowl = test::Bowl();
  // A mirrored parameter sphere.
  const SurfaceModel turned = bowl.Reparametrized(Vector3(-1.0, 1.0, 1.0).asDiagonal());
  ASSERT_LT(turned.Volume(), 0.0);
  const auto one = TrackerOf(*SurfaceContact(bowl), ToolShape::Sphere(0.5));
  const auto other = TrackerOf(*SurfaceContact(turned), ToolShape::Sphere(0.5));
  Random random(9106);
  for (int path = 0; path < 20; ++path)
  {
    one->Release();
    other->Release();
    test::FollowSurfacePath(bowl, 0.5, random,
                            [&](const Vector3& probe)
                            {
                              const Contact& here = one->Follow(At(probe));
                              const Contact& there = other->Follow(At(probe));
                              EXPECT_EQ(here.IsTouching, there.IsTouching);
                              EXPECT_LE((here.ProxyWorld - there.ProxyWorld).norm(), 1e-8);
                            });
  }
}

TEST(SurfaceModelContact, RejectsSurfacesThatCannotBeTouched)
{
  const auto refused = [](const SurfaceModel& surface)
  {
    std::shared_ptr<const ContactModel> contact;
    const Status status = MakeOrganContact(surface, contact);
    EXPECT_EQ(contact, nullptr);
    return !status.IsOk() && !status.Message().empty();
  };
  const std::vector<double> none(4, 0.0);
  EXPECT_TRUE(refused({1, {none, none, none}}));
  EXPECT_TRUE(refused(test::EllipsoidPhantom({20.0, 15.0, 0.0})));
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), 1e300, -std::numeric_limits<double>::infinity()})
  {
    std::vector<double> bad = none;
    bad[2] = wrong;
    EXPECT_TRUE(refused({1, {bad, none, none}}));
  }
}

TEST(SurfaceModelContact, RejectsOtherToolsThanSpheres)
{
  const auto model = SurfaceContact(test::EllipsoidPhantom({20.0, 15.0, 10.0}));
  std::unique_ptr<ContactTracker> tracker;
  EXPECT_FALSE(model->MakeTracker(ToolShape::Capsule(1.0, 3.0, 50), {}, tracker).IsOk());
  EXPECT_FALSE(model->MakeTracker(ToolShape::Sphere(1.0), {0.1, 0.2}, tracker).IsOk());
  EXPECT_EQ(tracker, nullptr);
  EXPECT_GT(model->Bytes(), 100000U);
}

TEST(WindingMesh, CountsHowOftenASurfaceWindsRoundAPoint)
{
  const WindingMesh ring = MeshOf(test::CrossingRing());
  const Vector3 center(5.0, 60.0, -30.0);
  EXPECT_EQ(ring.WindingNumber(center), 0);
  EXPECT_EQ(ring.WindingNumber(center + Vector3(20.0, 0.0, 0.0)), 1);
  EXPECT_EQ(ring.WindingNumber(center - Vector3(20.0, 0.0, 0.0)), 2);
  EXPECT_EQ(ring.WindingNumber(center + Vector3(0.0, 0.0, 1e6)), 0);
}

std::shared_ptr<const TouchableSurfaceModel> TouchSurfaceOf(const SurfaceModel& surface)
{
  std::shared_ptr<const TouchableSurfaceModel> touch;
  const Status status = TouchableSurfaceModel::Make(surface, touch);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return touch;
}

TEST(TouchableSurfaceModel, KnowsWhereItCrossesItself)
{
  const auto ring = TouchSurfaceOf(test::CrossingRing());
  EXPECT_TRUE(ring->CrossesItself());
  const Vector3 seam(5.0 - 20.0, 60.0, -30.0);
  for (const Vector3& place : ring->CrossingsWorld())
  {
    EXPECT_LT((place - seam).norm(), 20.0);
  }
  for (const auto& [name, surface] : test::SimplePhantoms())
  {
    EXPECT_FALSE(TouchSurfaceOf(surface)->CrossesItself()) << name;
  }
}

// Outside of the places at a crossing the nearest point alone holds a tool, so forces are exact: as
// long as the probe is on the normal through the place that it came down on, that is the foot.
TEST(SurfaceModelContact, ForcesAwayFromACrossingAreExact)
{
  const SurfaceModel surface = test::CrossingRing();
  const auto touch = TouchSurfaceOf(surface);
  const auto model = SurfaceContact(surface);
  const WedgePlaces places(*touch, 0.0, 1.0);
  const auto tracker = TrackerOf(*model, ToolShape::Sphere(0.0));
  Random random(9108);
  WorstCase error;
  int touches = 0;
  for (int path = 0; path < 200; ++path)
  {
    const Vector3 parameter = test::RandomDirection(random);
    if (places.IsBeside(parameter))
    {
      continue;
    }
    const auto place = touch->PlaceAt(parameter);
    tracker->Release();
    for (double depth = -0.23; depth < 1.0; depth += 0.1)
    {
      const Contact& contact = tracker->Follow(At(place.PointWorld - depth * place.Normal));
      error.Add(depth > 0.0 ? Stiffness * (contact.ProxyWorld - place.PointWorld).norm() : 0.0);
      touches += contact.IsTouching ? 1 : 0;
    }
  }
  EXPECT_GT(touches, 500);
  EXPECT_LE(error.Value(), 1e-9); // N
}

// A point needs the wedge at the seam only, a large sphere in the whole hole of the ring.
TEST(WedgePlaces, AreWhereAToolDoesNotFit)
{
  const auto ring = TouchSurfaceOf(test::CrossingRing());
  const Vector3 seam(5.0 - 20.0, 60.0, -30.0);
  const WedgePlaces point(*ring, 0.0, 1.0);
  const WedgePlaces sphere(*ring, 30.0, 1.0);
  const IcosahedronDirections parameters(30);
  int needed = 0;
  int neededBySphere = 0;
  for (const Vector3& u : parameters.Directions())
  {
    const Vector3 place = ring->PlaceAt(u).PointWorld;
    needed += point.Contains(u) ? 1 : 0;
    neededBySphere += sphere.Contains(u) ? 1 : 0;
    EXPECT_TRUE(!point.Contains(u) || point.IsBeside(u));
    EXPECT_TRUE(!point.Contains(u) || (place - seam).norm() < 25.0);
    const bool isCrossing =
        std::any_of(ring->CrossingsWorld().begin(), ring->CrossingsWorld().end(),
                    [&](const Vector3& crossing) { return (crossing - place).norm() < 0.2; });
    EXPECT_TRUE(!isCrossing || point.Contains(u)) << u.transpose();
  }
  const int all = static_cast<int>(parameters.Directions().size());
  EXPECT_GT(needed, 0);
  EXPECT_LT(needed, all / 2);
  EXPECT_GT(neededBySphere, all / 3);
  for (const auto& [name, surface] : test::SimplePhantoms())
  {
    EXPECT_TRUE(WedgePlaces(*TouchSurfaceOf(surface), 0.0, 1.0).IsEmpty()) << name;
  }
}

// Of places up to `reach` above the surface: how many are known to have their nearest point below
// them, all of which are checked.
int CountKnownNearest(const TouchableSurfaceModel& surface, double reach, Random& random)
{
  const WedgePlaces places(surface, 0.0, reach);
  std::uniform_real_distribution<double> height(0.0, reach);
  int known = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const TouchableSurfaceModel::Place place = surface.PlaceAt(test::RandomDirection(random));
    const Vector3 query = place.PointWorld + height(random) * place.Normal;
    const auto nearest = surface.Search().Nearest(query);
    const auto minimum =
        surface.Search().Track(query, surface.PointAt(place.Direction, query, nearest));
    if (minimum.Converged() && minimum.SignedDistance > 0.0 && places.IsNearest(minimum))
    {
      ++known;
      EXPECT_LE((nearest.PointWorld - minimum.PointWorld).norm(), 1e-6); // mm, Newton's method
    }
  }
  return known;
}

// Also so high above the surface that other parts are near.
TEST(WedgePlaces, AMinimumWithRoomIsTheNearestPoint)
{
  Random random(9110);
  for (const auto& [name, surface] : test::SimplePhantoms())
  {
    const auto touched = TouchSurfaceOf(surface);
    const double size = touched->SmallestRadius();
    EXPECT_GT(CountKnownNearest(*touched, 0.25 * size, random), 1000) << name; // as in use
    EXPECT_GT(CountKnownNearest(*touched, 1.0 * size, random), 300) << name;
  }
}

TEST(WedgePlaces, AreEverywhereOnASurfaceOfMoreCrossingsThanAreListed)
{
  constexpr int Degree = 24;
  Random random(9109);
  std::normal_distribution<double> normal;
  std::array<std::vector<double>, 3> coefficients;
  for (std::vector<double>& values : coefficients)
  {
    values.resize((Degree + 1) * (Degree + 1));
    std::generate(values.begin(), values.end(), [&] { return normal(random); });
  }
  const auto tangle = TouchSurfaceOf(SurfaceModel(Degree, coefficients));
  ASSERT_EQ(tangle->CrossingsWorld().size(), TouchableSurfaceModel::MostCrossings);
  const WedgePlaces places(*tangle, 0.0, 1.0);
  const IcosahedronDirections parameters(30);
  for (const Vector3& u : parameters.Directions())
  {
    EXPECT_TRUE(places.Contains(u));
  }
}
} // namespace
} // namespace palpate::parametric_contact_model_test
