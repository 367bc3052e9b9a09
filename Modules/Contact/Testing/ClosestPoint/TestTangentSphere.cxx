#include "TangentSphere.h"

#include "CenteredSurfaceSample.h"
#include "IcosahedronDirections.h"
#include "SurfacePhantoms.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

namespace palpate::tangent_sphere_test
{
namespace
{
using test::Random;
using Search = ClosestPointSearchOf<CenteredSurface>;

double RadiusAt(const Search& search, const Vector3& parameter, double side, double largest)
{
  const auto sample = search.Model().EvaluateSecondOrder(parameter);
  return LargestTangentSphere(search, sample, side * NormalOf(sample), largest);
}

// Of an ellipsoid of revolution with the axes a, a, c: from inside, on the equator, the smaller one
// of a and the curvature's radius along the meridian c^2 / a; outside there is no limit.
TEST(TangentSphere, InAnEllipsoidItIsThatOfTheCurvatureOrTheAxis)
{
  for (const auto& [a, c] : {std::pair(20.0, 12.0), std::pair(12.0, 20.0), std::pair(15.0, 15.0)})
  {
    const Search search(
        std::make_shared<const CenteredSurface>(test::EllipsoidPhantom(Vector3(a, a, c))));
    constexpr double Largest = 50.0; // mm
    const double expected = std::min(a, c * c / a);
    EXPECT_NEAR(RadiusAt(search, Vector3::UnitX(), -1.0, Largest), expected, 0.01 * expected);
    EXPECT_EQ(RadiusAt(search, Vector3::UnitX(), 1.0, Largest), Largest);
  }
}

// Some of these directions are middles of parts, which are the place itself up to rounding.
TEST(TangentSphere, OutsideAnEllipsoidNothingLimitsIt)
{
  constexpr double Largest = 5.0; // mm
  const Search search(
      std::make_shared<const CenteredSurface>(test::EllipsoidPhantom({25.0, 18.0, 9.0}, 16)));
  for (const int frequency : {6, 15, 48})
  {
    const IcosahedronDirections sphere(frequency);
    for (const Vector3& parameter : sphere.Directions())
    {
      ASSERT_EQ(RadiusAt(search, parameter, 1.0, Largest), Largest) << parameter.transpose();
    }
  }
}

// Next to the search of the whole surface: a sphere a little smaller is free, one a little larger
// is not.
TEST(TangentSphere, IsTheLargestThatIsFree)
{
  constexpr double Largest = 25.0; // mm
  // Of the radius: the trials end there, and a search is exact.
  constexpr double Allowed = 0.02;
  Random random(9433);
  for (const SurfaceModel& surface : {test::BumpyTube(random), test::Bowl(), test::CleftBlob()})
  {
    const Search search(std::make_shared<const CenteredSurface>(surface));
    int limited = 0;
    for (int trial = 0; trial < 2000; ++trial)
    {
      const Vector3 parameter = test::RandomDirection(random);
      const auto sample = search.Model().EvaluateSecondOrder(parameter);
      const Vector3 normal = NormalOf(sample);
      const double radius = LargestTangentSphere(search, sample, normal, Largest);
      const auto overlapOf = [&](double size)
      {
        const Vector3 center = search.Model().CenterWorld() + sample.Point + size * normal;
        return size - std::abs(search.Nearest(center).SignedDistance);
      };
      const double smaller = (1.0 - Allowed) * radius;
      ASSERT_LE(overlapOf(smaller), Allowed * smaller) << trial << " " << radius;
      if (radius < Largest)
      {
        ASSERT_GT(overlapOf(1.1 * radius), 0.0) << trial << " " << radius;
        ++limited;
      }
    }
    EXPECT_GT(limited, 20);
  }
}
} // namespace
} // namespace palpate::tangent_sphere_test
