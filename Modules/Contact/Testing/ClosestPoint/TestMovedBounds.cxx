#include "MovedBounds.h"

#include "SphericalTriangle.h"
#include "SurfacePhantoms.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace palpate::moved_bounds_test
{
namespace
{
using test::Random;

// A part of a surface, as dense samples.
struct SampledPart
{
  std::vector<Vector3> Points;
  Vector3 Center;
  double Extent = 0.0; // mm

  double DistanceFrom(const Vector3& place) const
  {
    double nearest = 1e300;
    for (const Vector3& point : this->Points)
    {
      nearest = std::min(nearest, (point - place).norm());
    }
    return nearest;
  }
};

// Of a random triangle of parameters, quartered up to five times.
SampledPart RandomPart(const SurfaceModel& surface, Random& random)
{
  constexpr int Samples = 24; // along a side
  SphericalTriangle triangle = SphericalTriangle::Icosahedron()[random() % 20];
  for (std::size_t split = random() % 6; split > 0; --split)
  {
    triangle = triangle.Split()[random() % 4];
  }
  SampledPart part;
  part.Center = surface.Point(triangle.Cap().Center);
  for (int i = 0; i <= Samples; ++i)
  {
    for (int j = 0; i + j <= Samples; ++j)
    {
      const Vector3 parameter = i * triangle.Corners[0] + j * triangle.Corners[1] +
                                (Samples - i - j) * triangle.Corners[2];
      part.Points.push_back(surface.Point(parameter.normalized()));
      part.Extent = std::max(part.Extent, (part.Points.back() - part.Center).norm());
    }
  }
  return part;
}

TEST(MovedBounds, AreLowerBoundsWhereverThePlaceMoves)
{
  Random random(9401);
  const SurfaceModel surface = test::BumpyTube(random);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int trial = 0; trial < 300; ++trial)
  {
    std::vector<SampledPart> parts;
    MovedBounds bounds;
    bounds.Forget();
    for (std::size_t i = 0; i < MovedBounds::Count; ++i)
    {
      parts.push_back(RandomPart(surface, random));
      const SampledPart& part = parts.back();
      const Vector3 place =
          part.Center + (part.Extent + 10.0 * uniform(random)) * test::RandomDirection(random);
      const double lower = part.DistanceFrom(place) * (1.0 - 0.1 * uniform(random));
      bounds.Set(i, place, lower, part.Center, part.Extent);
      for (const double step : {0.0, 0.01, 0.3, 3.0, 30.0})
      {
        const Vector3 moved = place + step * test::RandomDirection(random);
        alignas(sizeof(FourLanes)) FourLanes bound;
        bounds.Move(moved, bound);
        for (std::size_t j = 0; j <= i; ++j)
        {
          ASSERT_LE(bound[j], parts[j].DistanceFrom(moved) + 1e-9) << trial; // rounding
        }
      }
    }
  }
}

TEST(MovedBounds, StepsAlongASurfaceHardlyChangeThem)
{
  constexpr double Distance = 4.0; // mm
  constexpr double Extent = 0.05;
  MovedBounds bounds;
  bounds.Forget();
  bounds.Set(2, Vector3::Zero(), Distance - Extent, Distance * Vector3::UnitZ(), Extent);
  alignas(sizeof(FourLanes)) FourLanes bound;
  bounds.Move(Vector3::Zero(), bound);
  EXPECT_NEAR(bound[2], Distance - Extent, 1e-12);
  bounds.Move(0.2 * Vector3::UnitX(), bound);
  EXPECT_GT(bound[2], Distance - Extent - 0.01); // a path of 0.2 mm alone would take 0.2
  bounds.Move(0.2 * Vector3::UnitZ(), bound);
  EXPECT_NEAR(bound[2], Distance - Extent - 0.2, 0.01);
}

TEST(MovedBounds, PartsWithoutABoundMayBeAnywhere)
{
  MovedBounds bounds;
  bounds.Forget();
  bounds.Set(1, Vector3::Zero(), 3.0, 3.0 * Vector3::UnitX(), 0.0);
  alignas(sizeof(FourLanes)) FourLanes bound;
  bounds.Move(Vector3::UnitY(), bound);
  EXPECT_EQ(bound[0], 0.0);
  EXPECT_GT(bound[1], 3.0);
  EXPECT_EQ(bound[2], 0.0);
  EXPECT_EQ(bound[3], 0.0);
}
} // namespace
} // namespace palpate::moved_bounds_test
