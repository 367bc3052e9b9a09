#include "ClosestPointSearch.h"
#include "IcosahedronDirections.h"
#include "ParametricPhantoms.h"
#include "ParametricSample.h"
#include "PointDerivativeBounds.h"
#include "SurfaceBox.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace palpate
{
namespace
{
using test::Random;
using Search = ClosestPointSearchOf<ParametricShape>;

std::vector<ParametricSphericalSurface> Phantoms()
{
  Random random(5);
  return {test::EllipsoidPhantom({25.0, 20.0, 16.0}, 4), test::OpenRing(12), test::Bowl(12),
          test::BumpyTube(random, 12), test::CrossingRing(12)};
}

std::shared_ptr<const ParametricShape> Shaped(const ParametricSphericalSurface& surface)
{
  return std::make_shared<const ParametricShape>(surface);
}

TEST(ParametricShape, EvaluatesThePointsOfItsSurface)
{
  Random random(9201);
  const ParametricSphericalSurface surface = test::BumpyTube(random);
  const ParametricShape shape(surface);
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
  for (const ParametricSphericalSurface& surface : Phantoms())
  {
    const ParametricShape shape(surface);
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

TEST(SurfaceBox, ContainsItsPartOfSurface)
{
  Random random(9203);
  for (const ParametricSphericalSurface& surface : Phantoms())
  {
    const ParametricShape shape(surface);
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

TEST(ParametricClosestPoint, NearestIsNoFartherThanAnyPointAndProven)
{
  Random random(9204);
  const IcosahedronDirections dense(50);
  for (const ParametricSphericalSurface& surface : Phantoms())
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

TEST(ParametricClosestPoint, TrackingFollowsTheMinimumAndItsSide)
{
  Random random(9205);
  const ParametricSphericalSurface surface = test::OpenRing();
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

TEST(ParametricClosestPoint, RejectsQueriesThatAreNotFinite)
{
  const Search search(Shaped(test::EllipsoidPhantom({3.0, 2.0, 1.0})));
  const Vector3 nowhere = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(search.Nearest(nowhere).State, Search::ClosestPoint::Outcome::BadInput);
  EXPECT_GT(search.Bytes(), 10000U);
}
} // namespace
} // namespace palpate
