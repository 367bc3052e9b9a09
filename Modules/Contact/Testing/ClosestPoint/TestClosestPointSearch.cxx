#include "ClosestPointSearch.h"

#include "NearestByBruteForce.h"
#include "ProjectedShapes.h"
#include "RandomShapes.h"

#include <gtest/gtest.h>

namespace palpate::closest_point_search_test
{
namespace
{
using Outcome = ClosestPoint::Outcome;
using test::Random;

ClosestPointSearch SearchOn(const RadialModel& model)
{
  return ClosestPointSearch(std::make_shared<const RadialModel>(model));
}

double MeanRadius(const RadialModel& model)
{
  return model.Coefficients()[0] / std::sqrt(4.0 * M_PI);
}

// Queries inside, outside, close to the surface, far away, and on the medial axis: a query on the
// line inwards from a surface point, where that point stops being the closest one.
std::vector<Vector3> Queries(Random& random, const ClosestPointSearch& search, int count)
{
  const RadialModel& model = search.Model();
  std::uniform_real_distribution<double> uniform;
  std::vector<Vector3> queries{model.CenterWorld()};
  for (int i = 0; i < count; ++i)
  {
    const Vector3 u = test::RandomDirection(random);
    const Vector3 x = model.PointWorld(u);
    const Vector3 outwards = x - model.CenterWorld();
    queries.emplace_back(model.CenterWorld() + uniform(random) * outwards);
    queries.emplace_back(x + 2.0 * uniform(random) * outwards);
    queries.emplace_back(x + 0.05 * (uniform(random) - 0.5) * outwards);
    queries.emplace_back(x + 1e6 * outwards);
    double near = 0.0;
    double far = 4.0 * MeanRadius(model);
    while (far - near > 1e-12 * far)
    {
      const double depth = 0.5 * (near + far);
      const ClosestPoint found = search.Nearest(x - depth * model.Normal(u));
      (std::abs(found.SignedDistance) < depth * (1.0 - 1e-9) ? far : near) = depth;
    }
    queries.emplace_back(x - near * model.Normal(u));
  }
  return queries;
}

void ExpectConsistent(const RadialModel& model, const Vector3& query, const ClosestPoint& found)
{
  const double scale =
      (query - model.CenterWorld()).norm() + MeanRadius(model) + model.CenterWorld().norm();
  // Roundings of coordinates; PointWorld is the surface's to that.
  EXPECT_NEAR(found.Direction.norm(), 1.0, 1e-15);
  EXPECT_LE((found.PointWorld - model.PointWorld(found.Direction)).norm(), 1e-14 * scale);
  EXPECT_LE((found.Normal - model.Normal(found.Direction)).norm(), 1e-10);
  EXPECT_NEAR(std::abs(found.SignedDistance), (query - found.PointWorld).norm(), 1e-14 * scale);
}

TEST(ClosestPointSearch, IsExactOnSpheresOfAnySize)
{
  Random random(931);
  for (const double radius : {1e-3, 20.0, 1e4})
  {
    const Vector3 center = radius * Vector3(1.0, -2.0, 3.0);
    const ClosestPointSearch search = SearchOn(test::Sphere(radius, center));
    for (const double distance : {1e-6, 0.3, 0.999999, 1.0, 1.000001, 2.0, 1e6})
    {
      const Vector3 u = test::RandomDirection(random);
      const ClosestPoint found = search.Nearest(center + distance * radius * u);
      const double scale = radius * (4.0 + distance);
      EXPECT_EQ(found.State, Outcome::Minimum);
      // Rounding of the query's coordinates, and for the direction divided by its distance.
      EXPECT_NEAR(found.SignedDistance, (distance - 1.0) * radius, 1e-15 * scale);
      EXPECT_LE((found.Direction - u).norm(), 1e-15 * (4.0 + distance) / distance);
      EXPECT_LE((found.Normal - u).norm(), 1e-15 * (4.0 + distance) / distance);
      EXPECT_LE(found.DistanceError, 1e-14 * scale);
    }
  }
}

TEST(ClosestPointSearch, AcceptsAnyDirectionAtSphereCentre)
{
  const ClosestPointSearch search = SearchOn(test::Sphere(5.0));
  const ClosestPoint found = search.Nearest(Vector3::Zero());
  EXPECT_EQ(found.State, Outcome::Stationary);
  EXPECT_NEAR(found.SignedDistance, -5.0, 1e-14);
  EXPECT_LE(found.DistanceError, 1e-13);
  EXPECT_EQ(found.PositionError, INFINITY);
}

// Distance to an ellipsoid with half axes `axes` along x, y, z: the nearest point x solves
// x_i = a_i^2 p_i / (t + a_i^2) with the largest root t of sum (a_i p_i / (t + a_i^2))^2 = 1
// (Eberly, Distance from a Point to an Ellipsoid, 2013). Not for points in the planes of symmetry.
double EllipsoidDistance(const Vector3& axes, const Vector3& p)
{
  const Vector3 squares = axes.cwiseProduct(axes);
  double low = -squares.minCoeff();
  double high = axes.maxCoeff() * p.norm() + 1.0;
  for (int i = 0; i < 200; ++i)
  {
    const double t = 0.5 * (low + high);
    const Vector3 terms =
        axes.cwiseProduct(p).cwiseQuotient(squares.array().matrix() + Vector3::Constant(t));
    (terms.squaredNorm() > 1.0 ? low : high) = t;
  }
  const Vector3 x =
      squares.cwiseProduct(p).cwiseQuotient(squares + Vector3::Constant(0.5 * (low + high)));
  return (p - x).norm();
}

TEST(ClosestPointSearch, AgreesWithEquationOfEllipsoid)
{
  Random random(932);
  const Vector3 axes(20.0, 24.0, 28.0);
  const ClosestPointSearch search = SearchOn(test::Ellipsoid(axes, Matrix3::Identity(), 40));
  for (int i = 0; i < 60; ++i)
  {
    const Vector3 query =
        std::uniform_real_distribution<double>(0.2, 60.0)(random) * test::RandomDirection(random);
    const double inside = query.cwiseQuotient(axes).norm() < 1.0 ? -1.0 : 1.0;
    const ClosestPoint found = search.Nearest(query);
    // The series of degree 40 differs from the ellipsoid by some 1e-10 mm.
    EXPECT_NEAR(found.SignedDistance, inside * EllipsoidDistance(axes, query), 1e-9);
  }
  EXPECT_NEAR(search.Nearest(Vector3::Zero()).SignedDistance, -20.0, 1e-9);
}

TEST(ClosestPointSearch, MatchesBruteForceWithinReportedError)
{
  Random random(933);
  const std::vector<RadialModel> models{
      test::RandomOrgan(random, 12),      test::RandomOrgan(random, 20),
      test::RandomRough(random, 12, 20.), test::RandomRough(random, 8, 1e-3),
      test::RandomRough(random, 10, 1e4), test::RandomRough(random, 3, 20.)};
  for (const RadialModel& model : models)
  {
    const ClosestPointSearch search = SearchOn(model);
    const test::NearestByBruteForce oracle(model);
    const double radius = MeanRadius(model);
    for (const Vector3& query : Queries(random, search, 6))
    {
      const ClosestPoint found = search.Nearest(query);
      ExpectConsistent(model, query, found);
      const double distance = std::abs(found.SignedDistance);
      const double expected = oracle.Distance(query);
      // Roundings of numbers of this size.
      const double rounding = 1e-14 * (radius + distance + model.CenterWorld().norm());
      EXPECT_LE(distance, expected + rounding) << model.Degree() << " radius " << radius;
      EXPECT_GE(expected, distance - found.DistanceError);
      // Where many parts are almost equally close the proof may stay incomplete, by an amount that
      // the limit of evaluations determines.
      EXPECT_LE(found.DistanceError, 0.1 * radius);
    }
  }
}

TEST(ClosestPointSearch, ErrorBoundHoldsForFewEvaluations)
{
  Random random(934);
  for (int sample = 0; sample < 4; ++sample)
  {
    const RadialModel model =
        sample % 2 == 0 ? test::RandomOrgan(random, 10) : test::RandomRough(random, 10, 20.0);
    const ClosestPointSearch search = SearchOn(model);
    for (const Vector3& query : Queries(random, search, 4))
    {
      const double exact = std::abs(search.Nearest(query, 4000).SignedDistance);
      for (const int limit : {0, 1, 2, 3, 5, 8, 13, 21, 34, 55})
      {
        const ClosestPoint found = search.Nearest(query, limit);
        ExpectConsistent(model, query, found);
        const double distance = std::abs(found.SignedDistance);
        // One step may end the search only after the four parts of a piece.
        EXPECT_LE(found.Evaluations, limit + 5);
        EXPECT_GE(distance, exact * (1.0 - 1e-14) - 1e-13);
        EXPECT_LE(distance - found.DistanceError, exact);
      }
    }
  }
}

TEST(ClosestPointSearch, ProvesDistancesNearTheSurfaceOfOrgans)
{
  Random random(935);
  const ClosestPointSearch search = SearchOn(test::RandomOrgan(random, 12));
  long evaluations = 0;
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 u = test::RandomDirection(random);
    const double height = std::uniform_real_distribution<double>(-2.0, 10.0)(random); // mm
    const ClosestPoint found =
        search.Nearest(search.Model().PointWorld(u) + height * search.Model().Normal(u));
    EXPECT_TRUE(found.Converged());
    // Rounding of coordinates of up to 200 mm, 64 units in the last place.
    EXPECT_LE(found.DistanceError, 1e-11);
    EXPECT_LE(found.PositionError, 1e-10);
    EXPECT_NEAR(found.SignedDistance, height, 1e-12);
    evaluations += found.Evaluations;
  }
  EXPECT_LE(evaluations, 300 * 12); // 5 on average when this was written
}

TEST(ClosestPointSearch, ClearanceIsSafeAndProvesTwoThirds)
{
  Random random(930);
  int spared = 0;
  for (const RadialModel& model :
       {test::RandomOrgan(random, 12), test::RandomRough(random, 12, 20.0)})
  {
    const ClosestPointSearch search = SearchOn(model);
    constexpr double ToolRadius = 2.0;
    for (int i = 0; i < 300; ++i)
    {
      const Vector3 u = test::RandomDirection(random);
      const Vector3 query = model.PointWorld(u) + (ToolRadius + 0.02 * i) * model.Normal(u);
      const ClosestPoint truth = search.Nearest(query, 20000);
      const ClosestPoint found = search.Clearance(query, ToolRadius, 20000);
      const double exact = std::abs(truth.SignedDistance);
      const double proven = std::abs(found.SignedDistance) - found.DistanceError;
      const double rounding = 1e-9; // mm, far above that of numbers of 100 mm
      ASSERT_LE(proven, exact + rounding);
      const double path = std::max(0.0, std::abs(found.SignedDistance) - ToolRadius);
      ASSERT_LE(found.DistanceError, ClosestPointSearch::ClearanceLeftOpen * path + rounding);
      spared += truth.Evaluations - found.Evaluations;
    }
  }
  EXPECT_GT(spared, 1000);
}

TEST(ClosestPointSearch, ReturnsQueriesOnTheSurface)
{
  Random random(936);
  for (const bool rough : {false, true})
  {
    const ClosestPointSearch search =
        SearchOn(rough ? test::RandomRough(random, 12, 20.0) : test::RandomOrgan(random, 12));
    const RadialModel& model = search.Model();
    std::vector<Vector3> directions = test::RandomDirections(random, 60);
    directions.insert(directions.end(), {Vector3::UnitZ(), -Vector3::UnitZ()});
    for (const Vector3& u : directions)
    {
      const Vector3 x = model.PointWorld(u);
      const ClosestPoint found = search.Nearest(x);
      // Rounding of coordinates of up to 200 mm, and of radii by another formulation than x.
      EXPECT_LE(std::abs(found.SignedDistance), 2e-12);
      EXPECT_LE((found.PointWorld - x).norm(), 2e-12);
      const ClosestPoint again = search.Nearest(found.PointWorld);
      EXPECT_LE((again.PointWorld - found.PointWorld).norm(), 2e-12);
    }
  }
}

TEST(ClosestPointSearch, SignedDistanceIsOneLipschitz)
{
  Random random(937);
  const ClosestPointSearch search = SearchOn(test::RandomRough(random, 9, 20.0));
  std::uniform_real_distribution<double> uniform(-40.0, 40.0);
  const auto any = [&]
  {
    return Vector3(search.Model().CenterWorld() +
                   Vector3(uniform(random), uniform(random), uniform(random)));
  };
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 a = any();
    const Vector3 b = i % 2 == 0 ? any() : Vector3(a + 1e-3 * test::RandomDirection(random));
    const double difference = search.Nearest(a).SignedDistance - search.Nearest(b).SignedDistance;
    EXPECT_LE(std::abs(difference), (a - b).norm() + 1e-12); // rounding
  }
}

TEST(ClosestPointSearch, GradientOfSignedDistanceIsNormal)
{
  Random random(938);
  const ClosestPointSearch search = SearchOn(test::RandomOrgan(random, 8));
  for (const Vector3& u : test::RandomDirections(random, 40))
  {
    const double height = std::uniform_real_distribution<double>(-3.0, 10.0)(random);
    const Vector3 query = search.Model().PointWorld(u) + height * search.Model().Normal(u);
    const Vector3 normal = search.Nearest(query).Normal;
    constexpr double H = 1e-3; // mm
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3 step = H * Vector3::Unit(axis);
      const double slope = (search.Nearest(query + step).SignedDistance -
                            search.Nearest(query - step).SignedDistance) /
                           (2.0 * H);
      // The difference has an error of H^2 times squared curvatures of up to 1 / mm, plus 1e-13 /
      // H.
      EXPECT_NEAR(slope, normal[axis], 1e-6);
    }
  }
}

TEST(ClosestPointSearch, SupportsNegativeRadii)
{
  Random random(939);
  std::vector<double> coefficients = test::RandomCoefficients(random, 6, 0.5);
  const RadialModel model(6, coefficients, Vector3(1.0, 2.0, 3.0));
  const ClosestPointSearch search = SearchOn(model);
  const test::NearestByBruteForce oracle(model);
  for (int i = 0; i < 40; ++i)
  {
    const Vector3 query =
        model.CenterWorld() +
        std::uniform_real_distribution<double>(0.0, 8.0)(random) * test::RandomDirection(random);
    // Many sheets intersect near the centre; they need more evaluations than a body does.
    const ClosestPoint found = search.Nearest(query, 4000);
    const double distance = std::abs(found.SignedDistance);
    EXPECT_LE(distance, oracle.Distance(query) + 1e-13); // rounding
    EXPECT_GE(oracle.Distance(query), distance - found.DistanceError);
  }
}

TEST(ClosestPointSearch, SupportsModelOfRadiusZero)
{
  const ClosestPointSearch search = SearchOn(RadialModel());
  const ClosestPoint found = search.Nearest({3.0, 0.0, 4.0});
  EXPECT_NEAR(found.SignedDistance, 5.0, 1e-14);
  EXPECT_EQ(found.PointWorld, Vector3::Zero());
  EXPECT_TRUE(search.Nearest(Vector3::Zero()).Normal.allFinite());
}

TEST(ClosestPointSearch, RejectsNonFiniteInput)
{
  Random random(940);
  const ClosestPointSearch search = SearchOn(test::RandomOrgan(random, 5));
  for (const double bad : {double(NAN), double(INFINITY), 1e200})
  {
    const ClosestPoint found = search.Nearest({0.0, bad, 1.0});
    EXPECT_EQ(found.State, Outcome::BadInput);
    EXPECT_EQ(found.DistanceError, INFINITY);
    EXPECT_TRUE(found.PointWorld.allFinite());
    EXPECT_EQ(search.Track({0.0, bad, 1.0}, found).State, Outcome::BadInput);
  }
  std::vector<double> coefficients(9, 1.0);
  coefficients[4] = NAN;
  const ClosestPointSearch broken = SearchOn({2, coefficients, Vector3::Zero()});
  EXPECT_EQ(broken.Nearest({1.0, 2.0, 3.0}).State, Outcome::BadInput);
}
} // namespace
} // namespace palpate::closest_point_search_test
