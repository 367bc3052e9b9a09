#include "ParametricSurfaceBounds.h"

#include "RandomShapes.h"
#include "SurfaceCases.h"

#include <gtest/gtest.h>

namespace palpate::parametric_surface_bounds_test
{
namespace
{
using test::Random;
using Second = ParametricSphericalSurface::SecondOrderSample;

// Largest |X_tt| over many tangents at one parameter.
double SampledSecond(const Second& sample)
{
  double largest = 0.0;
  for (int i = 0; i < 32; ++i)
  {
    const double c = std::cos(M_PI * i / 32);
    const double s = std::sin(M_PI * i / 32);
    largest = std::max(largest, (c * c * sample.Second[0] + 2.0 * c * s * sample.Second[1] +
                                 s * s * sample.Second[2])
                                    .norm());
  }
  return largest;
}

Vector3 Near(Random& random, const Vector3& u, double angle)
{
  const Vector3 tangent = u.cross(test::RandomDirection(random)).normalized();
  const double turn = angle * std::uniform_real_distribution<double>(0.0, 1.0)(random);
  return (std::cos(turn) * u + std::sin(turn) * tangent).normalized();
}

// A single harmonic, which attains its bounds, or a body.
std::vector<ParametricSphericalSurface> Surfaces()
{
  Random random(1501);
  std::vector<ParametricSphericalSurface> surfaces{test::ParametricEllipsoid({3.0, 5.0, 8.0})};
  for (const int degree : {3, 8, 12, 20})
  {
    surfaces.push_back(test::RandomSurface(random, degree));
    std::vector<double> highest((degree + 1) * (degree + 1), 0.0);
    highest.back() = 1.0;
    surfaces.push_back({degree, {highest, {}, {}}});
  }
  return surfaces;
}

TEST(ParametricSurfaceBounds, HoldEverywhere)
{
  Random random(1502);
  for (const ParametricSphericalSurface& surface : Surfaces())
  {
    const ParametricSurfaceBounds bounds(surface);
    double first = 0.0;
    double second = 0.0;
    for (const Vector3& u : test::RandomDirections(random, 20000))
    {
      const Second sample = surface.EvaluateSecondOrder(u);
      first = std::max(first, ParametricSurfaceBounds::LargestFirstAt(sample.First));
      second = std::max(second, SampledSecond(sample));
    }
    EXPECT_LE(first, bounds.First());
    EXPECT_LE(second, bounds.Second());
    // cos(L r) of the grid is 0.92; LargestSecondAt adds some per cent; samples miss the maximum.
    EXPECT_LE(bounds.First(), 1.12 * first) << surface.Degree();
    EXPECT_LE(bounds.Second(), 1.2 * second) << surface.Degree();
  }
}

TEST(ParametricSurfaceBounds, HoldInCaps)
{
  Random random(1503);
  for (const ParametricSphericalSurface& surface : Surfaces())
  {
    const ParametricSurfaceBounds bounds(surface);
    for (const Vector3& center : test::RandomDirections(random, 200))
    {
      const Second sample = surface.EvaluateSecondOrder(center);
      for (const double angle : {0.0, 0.003, 0.03, 0.1, 0.5})
      {
        const double first = bounds.FirstAround(sample, angle);
        const double second = bounds.SecondAround(sample, angle);
        EXPECT_LE(first, bounds.First());
        EXPECT_LE(second, bounds.Second());
        for (int i = 0; i < 20; ++i)
        {
          const Second other = surface.EvaluateSecondOrder(Near(random, center, angle));
          ASSERT_LE(ParametricSurfaceBounds::LargestFirstAt(other.First), first) << angle;
          ASSERT_LE(SampledSecond(other), second) << angle;
        }
      }
    }
  }
}

TEST(ParametricSurfaceBounds, SmallCapsHaveTheBoundOfTheirCentre)
{
  Random random(1504);
  const ParametricSphericalSurface surface = test::RandomSurface(random, 12);
  const ParametricSurfaceBounds bounds(surface);
  for (const Vector3& u : test::RandomDirections(random, 100))
  {
    const Second sample = surface.EvaluateSecondOrder(u);
    EXPECT_NEAR(bounds.SecondAround(sample, 1e-6), ParametricSurfaceBounds::LargestSecondAt(sample),
                1e-4 * bounds.Second());
    EXPECT_LE(ParametricSurfaceBounds::LargestSecondAt(sample), 1.42 * SampledSecond(sample));
  }
}

// Distance of a point from a triangle, by the plane and the three edges.
double DistanceFromTriangle(const Vector3& p, const std::array<Vector3, 3>& corner)
{
  const Vector3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
  double least = INFINITY;
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3& a = corner[i];
    const Vector3 edge = corner[(i + 1) % 3] - a;
    inside = inside && normal.dot(edge.cross(p - a)) >= 0.0;
    const double w = std::min(1.0, std::max(0.0, edge.dot(p - a) / edge.squaredNorm()));
    least = std::min(least, (p - a - w * edge).norm());
  }
  return inside ? std::abs(normal.dot(p - corner[0])) : least;
}

TEST(ParametricSurfaceBounds, PatchesStayNearTheirTriangles)
{
  Random random(1505);
  std::exponential_distribution<double> share;
  double closest = 0.0; // largest share of the bound that is used
  for (const ParametricSphericalSurface& surface : Surfaces())
  {
    const ParametricSurfaceBounds bounds(surface);
    for (SphericalTriangle triangle : SphericalTriangle::Icosahedron())
    {
      for (int level = 0; level < 5; ++level)
      {
        triangle = triangle.Split()[static_cast<std::size_t>(level) % 4];
        const double deviation = ParametricSurfaceBounds::DeviationFromTriangle(
            triangle, bounds.SecondOver(surface, triangle, level % 3));
        const std::array<Vector3, 3> corner{surface.Point(triangle.Corners[0]),
                                            surface.Point(triangle.Corners[1]),
                                            surface.Point(triangle.Corners[2])};
        for (int i = 0; i < 30; ++i)
        {
          const Vector3 u =
              (share(random) * triangle.Corners[0] + share(random) * triangle.Corners[1] +
               share(random) * triangle.Corners[2])
                  .normalized();
          const double distance = DistanceFromTriangle(surface.Point(u), corner);
          ASSERT_LE(distance, deviation);
          closest = std::max(closest, distance / deviation);
        }
      }
    }
  }
  EXPECT_GE(closest, 0.5); // else the bound is too wide to be of use
}

TEST(ParametricSurfaceBounds, SphereLeavesItsTrianglesByMoreThanAnEighth)
{
  // |X_tt| = 1. In the middle of an equilateral triangle the sphere is 1 - cos r, or edge^2 / 6,
  // above it: an eighth, which holds along the edges, would not do.
  const SphericalTriangle face = SphericalTriangle::Icosahedron()[0].Split()[3].Split()[3];
  const ParametricSphericalSurface sphere = test::ParametricEllipsoid({1.0, 1.0, 1.0});
  const double second =
      ParametricSurfaceBounds::LargestSecondAt(sphere.EvaluateSecondOrder(face.Corners[0]));
  EXPECT_NEAR(second, 1.0, 1e-14);
  const double deviation = ParametricSurfaceBounds::DeviationFromTriangle(face, second);
  const double height = 1.0 - std::cos(face.Cap().Radius);
  const double edge = std::acos(face.Corners[0].dot(face.Corners[1]));
  EXPECT_GT(height, edge * edge / 8.0);
  EXPECT_LE(height, deviation);
  EXPECT_GE(height, 0.8 * deviation);
}

TEST(ParametricSurfaceBounds, RefinementNarrowsTheBoundOverTriangles)
{
  Random random(1506);
  const ParametricSphericalSurface surface = test::RandomSurface(random, 12);
  const ParametricSurfaceBounds bounds(surface);
  double sums[4]{};
  for (const SphericalTriangle& face : SphericalTriangle::Icosahedron())
  {
    const SphericalTriangle triangle = face.Split()[3].Split()[3];
    for (int refinement = 0; refinement < 4; ++refinement)
    {
      sums[refinement] += bounds.SecondOver(surface, triangle, refinement);
    }
    for (const Vector3& u : triangle.Corners)
    {
      EXPECT_LE(SampledSecond(surface.EvaluateSecondOrder(u)),
                bounds.SecondOver(surface, triangle, 3));
    }
  }
  EXPECT_LT(sums[1], sums[0]);
  EXPECT_LT(sums[2], sums[1]);
  EXPECT_LT(sums[3], sums[2]);
}

TEST(ParametricSurfaceBounds, NonFiniteCoefficientsGiveNoBound)
{
  const ParametricSurfaceBounds bounds(test::ParametricEllipsoid({3.0, std::nan(""), 8.0}));
  EXPECT_TRUE(std::isnan(bounds.Second()));
  EXPECT_FALSE(bounds.First() > 0.0);
}

TEST(ParametricSurfaceBounds, PointHasNoDerivatives)
{
  const ParametricSphericalSurface point(0, {std::vector<double>{1.0}, {2.0}, {3.0}});
  EXPECT_LE(ParametricSurfaceBounds(point).Second(), 1e-10);
}
} // namespace
} // namespace palpate::parametric_surface_bounds_test
