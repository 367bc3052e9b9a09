#include "CapMaxima.h"
#include "CenteredSurfaceSample.h"
#include "ClearanceProof.h"
#include "ClosestPointSearch.h"
#include "IcosahedronDirections.h"
#include "PointDerivativeBounds.h"
#include "SurfaceBox.h"
#include "SurfacePhantoms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace palpate::parametric_closest_point_test
{
namespace
{
using test::Random;
using Search = ClosestPointSearchOf<CenteredSurface>;

std::vector<SurfaceModel> Phantoms()
{
  Random random(5);
  return {test::EllipsoidPhantom({25.0, 20.0, 16.0}, 4), test::OpenRing(12), test::Bowl(12),
          test::BumpyTube(random, 12), test::CrossingRing(12)};
}

std::shared_ptr<const CenteredSurface> Shaped(const SurfaceModel& surface)
{
  return std::make_shared<const CenteredSurface>(surface);
}

TEST(CenteredSurface, EvaluatesThePointsOfItsSurface)
{
  Random random(9201);
  const SurfaceModel surface = test::BumpyTube(random);
  const CenteredSurface shape(surface);
  for (const Vector3& u : test::RandomDirections(random, 100))
  {
    const Vector3 point = shape.CenterWorld() + shape.EvaluateSecondOrder(u).Point;
    EXPECT_LE((point - surface.Point(u)).norm(), 1e-11);
    EXPECT_LE((point - shape.PointWorld(u)).norm(), 1e-11);
  }
}

// The third derivative by a difference of second ones along a great circle.
TEST(PointDerivativeBounds, HoldEverywhereAndAreTight)
{
  Random random(9202);
  for (const SurfaceModel& surface : Phantoms())
  {
    const CenteredSurface shape(surface);
    const PointDerivativeBounds bounds(shape);
    std::array<double, 4> largest{};
    for (int i = 0; i < 2000; ++i)
    {
      const Vector3 u = test::RandomDirection(random);
      const Vector3 t = u.cross(test::RandomDirection(random)).normalized();
      const auto second = [&](double angle)
      {
        const Vector3 tangent = std::cos(angle) * t - std::sin(angle) * u;
        const auto s = shape.EvaluateSecondOrder(std::cos(angle) * u + std::sin(angle) * t);
        const double a = tangent.dot(s.Tangents[0]);
        const double b = tangent.dot(s.Tangents[1]);
        return Vector3(a * a * s.Second[0] + 2.0 * a * b * s.Second[1] + b * b * s.Second[2]);
      };
      const auto s = shape.EvaluateSecondOrder(u);
      constexpr double H = 1e-4;
      const Vector3 first = t.dot(s.Tangents[0]) * s.First[0] + t.dot(s.Tangents[1]) * s.First[1];
      const std::array<double, 4> sizes{s.Point.norm(), first.norm(), second(0.0).norm(),
                                        (second(H) - second(-H)).norm() / (2.0 * H)};
      EXPECT_LE(sizes[1], LargestFirst(s) * (1.0 + 1e-12));
      EXPECT_LE(sizes[2], LargestSecond(s) * (1.0 + 1e-12));
      EXPECT_LE(3.0 * std::abs(first.dot(second(0.0))), LargestProduct(s) * (1.0 + 1e-9) + 1e-9);
      for (std::size_t k = 0; k < sizes.size(); ++k)
      {
        largest[k] = std::max(largest[k], sizes[k]);
      }
    }
    for (std::size_t k = 0; k < largest.size(); ++k)
    {
      // The difference has an error of H^2 / 6 times fifth derivatives.
      EXPECT_LE(largest[k], bounds.Point[k] * (1.0 + 1e-5)) << k;
      EXPECT_GE(2.0 * largest[k], bounds.Point[k]) << k; // gaps, and 2000 samples
    }
    EXPECT_GE(bounds.PointThird, bounds.Point[3]);
  }
}

TEST(PointDerivativeBounds, HoldInCaps)
{
  Random random(9207);
  for (const SurfaceModel& surface : Phantoms())
  {
    const CenteredSurface shape(surface);
    const PointDerivativeBounds bounds(shape);
    int narrower = 0;
    for (int i = 0; i < 300; ++i)
    {
      const Vector3 center = test::RandomDirection(random);
      const double reach = 3.0 / shape.Degree() * std::uniform_real_distribution<double>()(random);
      const double bound = bounds.ThirdWithin(center, reach);
      narrower += bound < bounds.PointThird ? 1 : 0;
      for (int k = 0; k < 10; ++k)
      {
        const Vector3 side = center.cross(test::RandomDirection(random)).normalized();
        const double away =
            k == 0 ? reach : reach * std::uniform_real_distribution<double>()(random);
        const Vector3 u = std::cos(away) * center + std::sin(away) * side;
        const Vector3 t = u.cross(test::RandomDirection(random)).normalized();
        const auto second = [&](double angle)
        {
          const Vector3 tangent = std::cos(angle) * t - std::sin(angle) * u;
          const auto s = shape.EvaluateSecondOrder(std::cos(angle) * u + std::sin(angle) * t);
          const double a = tangent.dot(s.Tangents[0]);
          const double b = tangent.dot(s.Tangents[1]);
          return Vector3(a * a * s.Second[0] + 2.0 * a * b * s.Second[1] + b * b * s.Second[2]);
        };
        constexpr double H = 1e-4;
        // The difference has an error of H^2 / 6 times fifth derivatives.
        EXPECT_LE((second(H) - second(-H)).norm() / (2.0 * H),
                  bound * (1.0 + 1e-5) + 1e-5 * bounds.PointThird);
      }
    }
    EXPECT_GT(narrower, 0);
  }
}

TEST(CapMaxima, AreAtLeastTheLargestValueInACap)
{
  Random random(9208);
  const std::vector<Vector3> directions = test::RandomDirections(random, 400);
  std::vector<double> values;
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    values.push_back(std::uniform_real_distribution<double>()(random));
  }
  constexpr double Margin = 0.05;
  const CapMaxima maxima(directions, values, {0.1, 0.3, 4.0}, Margin, 20);
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 center = i < 6 ? Vector3((i % 2 == 0 ? 1.0 : -1.0) * Vector3::Unit(i / 2))
                                 : test::RandomDirection(random);
    for (const double angle : {0.0, 0.1, 0.2, 0.3, 1.0})
    {
      double largest = 0.0;
      double largestNear = 0.0; // of the next angle of the list, and a cell farther
      const double most = angle <= 0.1 ? 0.1 : angle <= 0.3 ? 0.3 : 4.0;
      for (std::size_t k = 0; k < values.size(); ++k)
      {
        const double away = std::acos(std::clamp(directions[k].dot(center), -1.0, 1.0));
        largest = away <= angle + Margin ? std::max(largest, values[k]) : largest;
        largestNear = away <= most + Margin + 0.2 ? std::max(largestNear, values[k]) : largestNear;
      }
      EXPECT_GE(maxima.Within(center, angle), largest);
      EXPECT_LE(maxima.Within(center, angle), largestNear * (1.0 + 1e-6) + 1e-6);
    }
  }
  EXPECT_EQ(maxima.Within(Vector3::UnitX(), 5.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(CapMaxima().Within(Vector3::UnitX(), 0.0), std::numeric_limits<double>::infinity());
}

TEST(StretchedBasin, HasNoPointThatIsCloser)
{
  Random random(9209);
  for (const SurfaceModel& surface : Phantoms())
  {
    const Search search(Shaped(surface));
    const CenteredSurface& shape = search.Model();
    int inside = 0;
    for (int i = 0; i < 200; ++i)
    {
      const Vector3 u = test::RandomDirection(random);
      const double height = std::uniform_real_distribution<double>(-3.0, 3.0)(random);
      const Vector3 query = surface.Point(u) + height * surface.Normal(u);
      const auto nearest = search.Nearest(query, 5000);
      const Vector3 relative = query - shape.CenterWorld();
      const auto basin = search.Descent().BasinAround(relative, nearest);
      EXPECT_LE(basin.LowerDistance, std::abs(nearest.SignedDistance) + 1e-12);
      if (nearest.Converged() && basin.Reach > 0.0)
      {
        EXPECT_GE(basin.LowerDistance, std::abs(nearest.SignedDistance) - 1e-9);
      }
      const double widest = 2.0 * basin.Reach / std::max(1e-3, basin.Stretch) + 1e-3;
      for (int k = 0; k < 50; ++k)
      {
        const Vector3 side =
            nearest.SampleDirection.cross(test::RandomDirection(random)).normalized();
        const double angle =
            std::min(3.0, 4.0 * widest) * std::uniform_real_distribution<double>()(random);
        const Vector3 v = std::cos(angle) * nearest.SampleDirection + std::sin(angle) * side;
        if (basin.Contains(nearest.SampleDirection, v, 0.0))
        {
          ++inside;
          EXPECT_GE((shape.EvaluateSecondOrder(v).Point - relative).norm(),
                    basin.LowerDistance - 1e-12);
        }
      }
    }
    EXPECT_GT(inside, 200);
  }
}

// The proof of a moving point, with jumps; nothing but the known minimum may be closer than it
// says.
TEST(SurfaceClearanceProof, HoldsForAnyDistanceAlongAPath)
{
  Random random(9210);
  const IcosahedronDirections dense(40);
  for (const SurfaceModel& surface : Phantoms())
  {
    const Search search(Shaped(surface));
    std::vector<Vector3> points;
    for (const Vector3& u : dense.Directions())
    {
      points.push_back(surface.Point(u));
    }
    const auto proof = std::make_unique<ClearanceProofOf<CenteredSurface>>(search, 0.5, 1e-6);
    Vector3 u = test::RandomDirection(random);
    int clear = 0;
    for (int step = 0; step < 300; ++step)
    {
      u = step % 40 == 39 ? test::RandomDirection(random)
                          : (u + 0.003 * test::RandomDirection(random)).normalized();
      const double height = 0.6 * std::sin(0.1 * step);
      const Vector3 query = surface.Point(u) + height * surface.Normal(u);
      const auto known = search.Nearest(query, 5000);
      const double distance = std::abs(known.SignedDistance) + (step % 3 == 0 ? 0.05 : 1e-5);
      const auto answer = proof->AskWithin(distance, query, &known, 1, 400, 0.0);
      EXPECT_LE(answer.Evaluations, 500);
      if (answer.State != ClearanceProofOf<CenteredSurface>::Finding::Clear)
      {
        continue;
      }
      ++clear;
      EXPECT_NEAR(answer.LowerDistance, distance, 2e-6);
      const auto basin = search.Descent().BasinAround(query - search.Model().CenterWorld(), known);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        if (!basin.Contains(known.SampleDirection, dense.Directions()[i], 0.0))
        {
          ASSERT_GE((points[i] - query).norm(), answer.LowerDistance - 1e-9);
        }
      }
    }
    EXPECT_GT(clear, 150);
  }
}

// Bounds that are kept while the query moves stay valid: a distance beyond the nearest point is
// never clear.
TEST(SurfaceClearanceProof, IsNeverClearBeyondTheNearestPoint)
{
  Random random(9211);
  using Finding = ClearanceProofOf<CenteredSurface>::Finding;
  for (const SurfaceModel& surface : Phantoms())
  {
    const Search search(Shaped(surface));
    const auto proof = std::make_unique<ClearanceProofOf<CenteredSurface>>(search, 2.0, 1e-6);
    Vector3 query = Vector3::Zero();
    int clear = 0;
    for (int step = 0; step < 600; ++step)
    {
      const Vector3 u = test::RandomDirection(random);
      query = step % 60 == 0 ? Vector3(surface.Point(u) + 3.0 * surface.Normal(u))
                             : Vector3(query + 0.1 * test::RandomDirection(random));
      const double distance = std::abs(search.Nearest(query, 5000).SignedDistance);
      EXPECT_NE(proof->AskWithin(1.001 * distance + 1e-5, query, nullptr, 0, 300).State,
                Finding::Clear);
      clear +=
          proof->AskWithin(0.98 * distance, query, nullptr, 0, 300).State == Finding::Clear ? 1 : 0;
    }
    EXPECT_GT(clear, 400);
  }
}

TEST(SurfaceBox, ContainsItsPartOfSurface)
{
  Random random(9203);
  for (const SurfaceModel& surface : Phantoms())
  {
    const CenteredSurface shape(surface);
    const double third = PointDerivativeBounds(shape).PointThird;
    for (int i = 0; i < 100; ++i)
    {
      const Vector3 u = test::RandomDirection(random);
      const double reach = std::pow(10.0, std::uniform_real_distribution<double>(-4, -0.3)(random));
      const SurfaceBox box(u, shape.EvaluateSecondOrder(u), reach, third);
      for (int k = 0; k < 20; ++k)
      {
        const double angle =
            k == 0 ? reach : reach * std::uniform_real_distribution<double>()(random);
        const Vector3 t = u.cross(test::RandomDirection(random)).normalized();
        const Vector3 x =
            shape.EvaluateSecondOrder(std::cos(angle) * u + std::sin(angle) * t).Point;
        constexpr double Slack = 1e-12; // rounding
        EXPECT_LE(box.LowerDistance(x), Slack);
        EXPECT_LE((x - box.Center()).norm(), box.Extent() + Slack);
        const Vector3 query = x + 10.0 * test::RandomDirection(random);
        EXPECT_LE(box.LowerDistance(query), (x - query).norm() + Slack);
      }
    }
  }
}

TEST(SurfaceClosestPoint, NearestIsNoFartherThanAnyPointAndProven)
{
  Random random(9204);
  const IcosahedronDirections dense(50);
  for (const SurfaceModel& surface : Phantoms())
  {
    const auto shape = Shaped(surface);
    const Search search(shape);
    std::vector<Vector3> points;
    for (const Vector3& u : dense.Directions())
    {
      points.push_back(shape->PointWorld(u));
    }
    for (int i = 0; i < 25; ++i)
    {
      const Vector3 query =
          shape->CenterWorld() + 1.5 * search.Tree().LargestRadius() *
                                     std::uniform_real_distribution<double>()(random) *
                                     test::RandomDirection(random);
      const auto nearest = search.Nearest(query, 5000);
      double least = std::numeric_limits<double>::infinity();
      for (const Vector3& point : points)
      {
        least = std::min(least, (point - query).norm());
      }
      const double distance = std::abs(nearest.SignedDistance);
      EXPECT_LE(distance, least + 1e-10);
      EXPECT_LE(nearest.DistanceError, 1e-9);
      EXPECT_NEAR((shape->PointWorld(nearest.Direction) - query).norm(), distance, 1e-10);
      // A shorter search is never wrong by more than it says.
      const auto shorter = search.Nearest(query, 40);
      EXPECT_LE(std::abs(shorter.SignedDistance) - shorter.DistanceError, distance + 1e-10);
      const auto clearance = search.Clearance(query, 1.0);
      EXPECT_LE(std::abs(clearance.SignedDistance) - clearance.DistanceError, distance + 1e-10);
      // Nor is one that begins at another query's result.
      const auto from = search.Nearest(query + test::RandomDirection(random), 5000);
      EXPECT_NEAR(std::abs(search.Nearest(query, 5000, from).SignedDistance), distance, 1e-9);
    }
  }
}

TEST(SurfaceClosestPoint, TrackingFollowsTheMinimumAndItsSide)
{
  Random random(9205);
  const SurfaceModel surface = test::OpenRing();
  const Search search(Shaped(surface));
  const Vector3 parameter = test::RandomDirection(random);
  const Vector3 normal = surface.Normal(parameter);
  auto point = search.Nearest(surface.Point(parameter) + normal);
  auto turned = point;
  turned.Normal = -turned.Normal;
  turned.SignedDistance = -turned.SignedDistance;
  for (int tick = 1; tick <= 60; ++tick)
  {
    // Through the surface.
    const Vector3 query = surface.Point(parameter) + (1.0 - 0.05 * tick) * normal;
    point = search.Track(query, point);
    turned = search.Track(query, turned);
    ASSERT_TRUE(point.Converged());
    EXPECT_LE(point.Evaluations, 3);
    EXPECT_LE((point.PointWorld - surface.Point(parameter)).norm(), 1e-8);
    EXPECT_NEAR(point.SignedDistance, 1.0 - 0.05 * tick, 1e-8);
    EXPECT_LE(point.PositionError, 1e-7);
    EXPECT_EQ(turned.SignedDistance, -point.SignedDistance);
    EXPECT_EQ(turned.Normal, Vector3(-point.Normal));
  }
}

TEST(SurfaceClosestPoint, RejectsQueriesThatAreNotFinite)
{
  const Search search(Shaped(test::EllipsoidPhantom({3.0, 2.0, 1.0})));
  const Vector3 nowhere = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(search.Nearest(nowhere).State, Search::ClosestPoint::Outcome::BadInput);
  EXPECT_GT(search.Bytes(), 10000U);
}
} // namespace
} // namespace palpate::parametric_closest_point_test
