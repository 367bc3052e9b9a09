#include "ClosestPointSearch.h"

#include "InstructionSets.h"
#include "NearestByBruteForce.h"
#include "ProjectedShapes.h"
#include "RandomShapes.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::closest_point_tracking_test
{
namespace
{
using Outcome = ClosestPoint::Outcome;
using test::NameOf;
using test::Random;
using test::RunnableInstructionSets;

ClosestPointSearch SearchOn(const RadialModel& model)
{
  return ClosestPointSearch(std::make_shared<const RadialModel>(model));
}

// Tracks from any unit vector.
ClosestPoint TrackFrom(const ClosestPointSearch& search, const Vector3& queryWorld,
                       const Vector3& direction)
{
  ClosestPoint start;
  start.SampleDirection = direction;
  start.Sample = search.Model().EvaluateSecondOrder(direction);
  return search.Track(queryWorld, start);
}

// A smooth path that stays between 95 % and 110 % of the radius, `step` mm per tick.
class Path
{
public:
  Path(Random& random, const RadialModel& model, double step)
      : Source(random), Model(model), Step(step), Velocity(test::RandomDirection(random)),
        Query(model.PointWorld(test::RandomDirection(random)))
  {
  }

  const Vector3& Next()
  {
    const Vector3 outwards = this->Query - this->Model.CenterWorld();
    const Vector3 u = outwards.normalized();
    const double ratio = outwards.norm() / this->Model.Radius(u);
    const double back = ratio > 1.1 ? -0.2 : ratio < 0.95 ? 0.2 : 0.0;
    this->Velocity =
        (this->Velocity + back * u + 0.05 * test::RandomDirection(this->Source)).normalized();
    this->Query += this->Step * this->Velocity;
    return this->Query;
  }

private:
  Random& Source;
  const RadialModel& Model;
  double Step;
  Vector3 Velocity;
  Vector3 Query;
};

TEST(ClosestPointTracking, EqualsGlobalSearchOnSmoothPaths)
{
  Random random(951);
  for (int sample = 0; sample < 3; ++sample)
  {
    const ClosestPointSearch search = SearchOn(test::RandomOrgan(random, 12));
    for (const double step : {0.01, 0.1, 1.0}) // mm
    {
      Path path(random, search.Model(), step);
      ClosestPoint tracked = search.Nearest(path.Next());
      for (int tick = 0; tick < 300; ++tick)
      {
        const Vector3 query = path.Next();
        tracked = search.Track(query, tracked);
        const ClosestPoint nearest = search.Nearest(query);
        ASSERT_TRUE(tracked.Converged()) << tick;
        // The error bounds that both report.
        EXPECT_NEAR(tracked.SignedDistance, nearest.SignedDistance,
                    tracked.DistanceError + nearest.DistanceError);
        EXPECT_LE((tracked.PointWorld - nearest.PointWorld).norm(),
                  tracked.PositionError + nearest.PositionError);
        // The tolerance in mm. The error of the distance is its square, plus that of the expansion
        // of the last step: |x'''| = 500 mm times the cube of at most 1e-4.
        EXPECT_LE(tracked.PositionError, 5e-6);
        EXPECT_LE(tracked.DistanceError, 1e-8);
        EXPECT_NEAR(tracked.SignedDistance, nearest.SignedDistance, 1e-10);
      }
    }
  }
}

TEST(ClosestPointTracking, NeedsOneEvaluationPerTickOnServoPaths)
{
  Random random(952);
  const ClosestPointSearch search = SearchOn(test::RandomOrgan(random, 12));
  for (const double step : {0.01, 0.1}) // mm: 10 and 100 mm/s at 1 kHz
  {
    Path path(random, search.Model(), step);
    ClosestPoint tracked = search.Nearest(path.Next());
    int evaluations = 0;
    constexpr int Ticks = 2000;
    for (int tick = 0; tick < Ticks; ++tick)
    {
      tracked = search.Track(path.Next(), tracked);
      evaluations += tracked.Evaluations;
    }
    EXPECT_LE(evaluations, 1.01 * Ticks);
  }
}

TEST(ClosestPointTracking, FollowsLocalMinimumOnRoughBodies)
{
  Random random(953);
  const ClosestPointSearch search = SearchOn(test::RandomRough(random, 12, 20.0));
  Path path(random, search.Model(), 0.1);
  ClosestPoint tracked = search.Nearest(path.Next());
  int apart = 0;
  int lost = 0;
  constexpr int Ticks = 1500;
  for (int tick = 0; tick < Ticks; ++tick)
  {
    const Vector3 query = path.Next();
    tracked = search.Track(query, tracked);
    const ClosestPoint nearest = search.Nearest(query);
    EXPECT_LE(std::abs(nearest.SignedDistance), std::abs(tracked.SignedDistance) + 1e-11);
    if (!tracked.Converged())
    {
      ++lost;
      tracked = nearest;
    }
    else if (std::abs(tracked.SignedDistance) - std::abs(nearest.SignedDistance) > 1e-9)
    {
      // Only because another point became closer: they are well apart.
      EXPECT_GT((tracked.PointWorld - nearest.PointWorld).norm(), 0.1);
      ++apart;
      tracked = nearest;
    }
    else
    {
      EXPECT_LE((tracked.PointWorld - nearest.PointWorld).norm(),
                tracked.PositionError + nearest.PositionError);
    }
  }
  EXPECT_LE(apart + lost, Ticks / 10);
}

TEST(ClosestPointTracking, DescendsFromAnyDirection)
{
  Random random(954);
  const ClosestPointSearch search = SearchOn(test::RandomRough(random, 12, 20.0));
  const RadialModel& model = search.Model();
  int converged = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 start = test::RandomDirection(random);
    const double far = std::pow(10.0, std::uniform_real_distribution<double>(-3, 6)(random));
    const Vector3 query = model.CenterWorld() + far * test::RandomDirection(random);
    const ClosestPoint found = TrackFrom(search, query, start);
    EXPECT_LE(found.Evaluations, ClosestPointSearch::TrackingEvaluationLimit);
    EXPECT_TRUE(found.PointWorld.allFinite());
    const double begin = (model.PointWorld(start) - query).norm();
    EXPECT_LE(std::abs(found.SignedDistance), begin * (1.0 + 1e-13) + 1e-12);
    converged += found.Converged() ? 1 : 0;
  }
  EXPECT_GT(converged, 1000);
}

TEST(ClosestPointTracking, ErrorBoundsHoldForOffCentreSphere)
{
  Random random(955);
  const Vector3 center(3.0, -2.0, 1.0);
  const ClosestPointSearch search = SearchOn(test::OffCenterSphere(10.0, center, 32));
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 normal = test::RandomDirection(random);
    const double height = std::uniform_real_distribution<double>(-5.0, 20.0)(random);
    const Vector3 query = center + (10.0 + height) * normal;
    // Start as far off as in a servo tick, and as after a jump.
    const double off = std::pow(10.0, std::uniform_real_distribution<double>(-6, -0.5)(random));
    const Vector3 start =
        (center + 10.0 * (normal + off * test::RandomDirection(random)).normalized()).normalized();
    const ClosestPoint found = TrackFrom(search, query, start);
    ASSERT_TRUE(found.Converged());
    // The series of degree 32 is the sphere except for rounding, which tilts it by about 1e-13 rad;
    // at a height of 20 mm the closest point moves by as many times that.
    const double series = 5e-12;
    const Vector3 exact = center + 10.0 * normal;
    EXPECT_LE((found.PointWorld - exact).norm(), found.PositionError + series);
    EXPECT_NEAR(found.SignedDistance, height, found.DistanceError + series);
  }
}

TEST(ClosestPointTracking, ErrorBoundsHoldAgainstTighterSolve)
{
  Random random(956);
  for (const double size : {1e-3, 20.0, 1e4})
  {
    const RadialModel model = test::RandomRough(random, 10, size);
    const ClosestPointDescent descent(model);
    for (int i = 0; i < 500; ++i)
    {
      const Vector3 u = test::RandomDirection(random);
      const auto sample = model.EvaluateSecondOrder(u);
      const double height = std::uniform_real_distribution<double>(-0.1, 0.5)(random) * size;
      const double off = std::pow(10.0, std::uniform_real_distribution<double>(-5, -1.5)(random));
      const Vector3 query =
          sample.Radius * u + height * model.Normal(u) + off * size * test::RandomDirection(random);
      const ClosestPoint loose = descent.Run(query, u, sample, 1e-4, 20);
      if (loose.Converged())
      {
        const ClosestPoint tight =
            descent.Run(query, loose.SampleDirection, loose.Sample, 1e-13, 20);
        EXPECT_LE((loose.PointWorld - tight.PointWorld).norm(),
                  loose.PositionError + tight.PositionError);
        EXPECT_NEAR(loose.SignedDistance, tight.SignedDistance,
                    loose.DistanceError + tight.DistanceError);
      }
    }
  }
}

TEST(ClosestPointTracking, InstructionSetsTrackTheSamePoint)
{
  Random random(958);
  const RadialModel model = test::RandomOrgan(random, 12);
  for (const InstructionSet set : RunnableInstructionSets())
  {
    const ClosestPointDescent descent(model, set);
    const ClosestPointDescent reference(model, InstructionSet::Portable);
    Path path(random, model, 0.05);
    const Vector3 u = (path.Next() - model.CenterWorld()).normalized();
    ClosestPoint tracked =
        reference.Run(path.Next() - model.CenterWorld(), u, model.EvaluateSecondOrder(u), 1e-7, 50);
    ASSERT_TRUE(tracked.Converged());
    for (int tick = 0; tick < 2000; ++tick)
    {
      const Vector3 query = path.Next() - model.CenterWorld();
      const ClosestPoint expected = reference.Continue(query, tracked, 1e-7, 8);
      tracked = descent.Continue(query, tracked, 1e-7, 8);
      ASSERT_TRUE(tracked.Converged()) << NameOf(set);
      ASSERT_LE((tracked.PointWorld - expected.PointWorld).norm(),
                tracked.PositionError + expected.PositionError)
          << NameOf(set);
    }
  }
}

// The last tick's curvature may belong to another place or be NaN: it only predicts the step.
TEST(ClosestPointTracking, WrongCurvatureCostsOnlyEvaluations)
{
  Random random(959);
  const RadialModel model = test::RandomOrgan(random, 12);
  const ClosestPointDescent descent(model);
  Path path(random, model, 0.5);
  const Vector3 u = (path.Next() - model.CenterWorld()).normalized();
  ClosestPoint tracked =
      descent.Run(path.Next() - model.CenterWorld(), u, model.EvaluateSecondOrder(u), 1e-7, 50);
  for (int tick = 0; tick < 500; ++tick)
  {
    const Vector3 query = path.Next() - model.CenterWorld();
    const Vector3 elsewhere = test::RandomDirection(random);
    ClosestPoint wrong = tracked;
    wrong.Expansion =
        SquaredDistance(elsewhere, model.EvaluateSecondOrder(elsewhere), 40.0 * elsewhere);
    if (tick % 10 == 0)
    {
      wrong.Expansion.Determinant = std::numeric_limits<double>::quiet_NaN();
    }
    tracked = descent.Continue(query, tracked, 1e-7, 8);
    const ClosestPoint found = descent.Continue(query, wrong, 1e-7, 50);
    ASSERT_TRUE(tracked.Converged());
    ASSERT_TRUE(found.Converged());
    ASSERT_LE((tracked.PointWorld - found.PointWorld).norm(),
              tracked.PositionError + found.PositionError);
  }
}

TEST(ClosestPointTracking, NoPointInBasinIsCloser)
{
  Random random(957);
  const RadialModel model = test::RandomRough(random, 8, 20.0);
  const ClosestPointDescent descent(model);
  int basins = 0;
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 u = test::RandomDirection(random);
    const Vector3 query = std::uniform_real_distribution<double>(0.5, 2.0)(random) *
                          model.Radius(u) * test::RandomDirection(random);
    const ClosestPoint found = descent.Run(query, u, model.EvaluateSecondOrder(u), 1e-12, 60);
    const auto basin = descent.BasinAround(query, found);
    basins += basin.Angle > 0.0 ? 1 : 0;
    for (int k = 0; k < 30; ++k)
    {
      const Vector3& v = found.SampleDirection;
      const Vector3 t = v.cross(test::RandomDirection(random)).normalized();
      const double angle = basin.Angle * std::uniform_real_distribution<double>()(random);
      const Vector3 w = std::cos(angle) * v + std::sin(angle) * t;
      EXPECT_GE((model.Radius(w) * w - query).norm(), basin.LowerDistance);
    }
    // And the bound over a cap anywhere.
    const double reach = std::pow(10.0, std::uniform_real_distribution<double>(-3, 0)(random));
    const double least = descent.LowerDistance(query, u, model.EvaluateSecondOrder(u), reach);
    for (int k = 0; k < 30; ++k)
    {
      const Vector3 t = u.cross(test::RandomDirection(random)).normalized();
      const double angle = reach * std::uniform_real_distribution<double>()(random);
      const Vector3 w = std::cos(angle) * u + std::sin(angle) * t;
      EXPECT_GE((model.Radius(w) * w - query).norm(), least - 1e-12);
    }
  }
  EXPECT_GT(basins, 200);
}

TEST(ClosestPointTracking, ReportsStationaryOppositeClosestPoint)
{
  const ClosestPointSearch search = SearchOn(test::Sphere(10.0));
  const ClosestPoint found = TrackFrom(search, {20.0, 0.0, 0.0}, Vector3(-1.0, 0.0, 0.0));
  EXPECT_EQ(found.State, Outcome::Stationary); // the farthest point
  EXPECT_FALSE(found.Converged());
  EXPECT_EQ(found.DistanceError, INFINITY);
  // Slightly off that direction the descent succeeds.
  const Vector3 nearby = Vector3(-1.0, 1e-6, 0.0).normalized();
  ClosestPoint next = TrackFrom(search, {20.0, 0.0, 0.0}, nearby);
  for (int tick = 0; tick < 3 && !next.Converged(); ++tick)
  {
    next = search.Track({20.0, 0.0, 0.0}, next);
  }
  EXPECT_TRUE(next.Converged());
  EXPECT_NEAR(next.SignedDistance, 10.0, 1e-14);
}

TEST(ClosestPointTracking, RejectsNanDirection)
{
  const ClosestPointSearch search = SearchOn(test::Sphere(10.0));
  const ClosestPoint found = TrackFrom(search, {20.0, 0.0, 0.0}, Vector3(NAN, 0.0, 1.0));
  EXPECT_EQ(found.State, Outcome::BadInput);
}

TEST(ToolContact, SphericalToolIsCloserByItsRadius)
{
  const Vector3 center(1.0, 2.0, 3.0);
  const ClosestPointSearch search = SearchOn(test::Sphere(10.0, center));
  const Vector3 u = Vector3(1.0, -2.0, 2.0) / 3.0;
  for (const double height : {5.0, 2.0, 0.5, -3.0})
  {
    const Vector3 query = center + (10.0 + height) * u;
    const ToolContact contact = search.TouchAnywhere(query, 2.0);
    // Some roundings of coordinates.
    EXPECT_NEAR(contact.SignedDistance, height - 2.0, 1e-13);
    EXPECT_LE((contact.ToolCenterWorld - (center + 12.0 * u)).norm(), 1e-13);
    EXPECT_LE(contact.Overlap, 1e-13);
  }
}

TEST(ToolContact, ToolIsPushedOutOfNarrowHollows)
{
  // Two lobes with a waist that is narrower than the tool.
  const RadialModel model =
      test::Project(8, [](const Vector3& u) { return 10.0 * (0.4 + u.z() * u.z()); });
  const ClosestPointSearch search = SearchOn(model);
  constexpr double ToolRadius = 9.0;
  Random random(958);
  int corrected = 0;
  for (int i = 0; i < 60; ++i)
  {
    const Vector3 u = test::RandomDirection(random);
    const Vector3 query =
        model.PointWorld(u) -
        std::uniform_real_distribution<double>(-8.0, 1.0)(random) * model.Normal(u);
    const ClosestPoint nearest = search.Nearest(query);
    const Vector3 local = nearest.PointWorld + ToolRadius * nearest.Normal;
    const ToolContact contact = search.TouchAnywhere(query, ToolRadius);
    const double left = search.Nearest(contact.ToolCenterWorld).SignedDistance - ToolRadius;
    // The termination tolerance of the pushes.
    EXPECT_GE(left, -1e-6) << i;
    EXPECT_NEAR(contact.Overlap, std::max(0.0, -left), 1e-12);
    corrected += (local - contact.ToolCenterWorld).norm() > 1e-3 ? 1 : 0;
  }
  EXPECT_GT(corrected, 3); // the case occurs
}
} // namespace
} // namespace palpate::closest_point_tracking_test
