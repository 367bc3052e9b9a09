#include "ShapeMirror.h"

#include "RandomShapes.h"
#include "SurfaceCases.h"

#include <gtest/gtest.h>

namespace palpate::shape_mirror_test
{
namespace
{
using test::Random;

Vector3 MirrorOf(const Vector3& point)
{
  return {-point[0], point[1], point[2]};
}

// Both sums have the same terms but for their signs; of some hundred terms near 10 mm.
constexpr double Rounding = 1e-12;

TEST(ShapeMirror, HasTheRadiusOfTheMirroredDirection)
{
  Random random(1);
  const RadialModel organ = test::RandomOrgan(random, 9);
  const RadialModel shape(9, organ.Coefficients(), Vector3(3.0, 4.0, 5.0));
  const auto mirrored = std::get<RadialModel>(MirrorShape(shape));
  EXPECT_EQ(mirrored.CenterWorld(), Vector3(-3.0, 4.0, 5.0));
  for (const Vector3& direction : test::RandomDirections(random, 200))
  {
    EXPECT_NEAR(mirrored.Radius(direction), shape.Radius(MirrorOf(direction)), Rounding);
  }
}

TEST(ShapeMirror, OfASurfaceHasTheMirroredPointsAndStaysOutsideOut)
{
  Random random(2);
  const SurfaceModel surface = test::RandomSurface(random, 8);
  const auto mirrored = std::get<SurfaceModel>(MirrorShape(surface));
  for (const Vector3& parameter : test::RandomDirections(random, 200))
  {
    EXPECT_LT((mirrored.Point(parameter) - MirrorOf(surface.Point(MirrorOf(parameter)))).norm(),
              10.0 * Rounding);
  }
  EXPECT_NEAR(mirrored.Volume(), surface.Volume(), 1e-9 * std::abs(surface.Volume()));
}

TEST(ShapeMirror, TwiceIsTheSameBits)
{
  Random random(3);
  const OrganModel radial = test::RandomOrgan(random, 12);
  EXPECT_EQ(std::get<RadialModel>(MirrorShape(MirrorShape(radial))).Coefficients(),
            std::get<RadialModel>(radial).Coefficients());
  const OrganModel surface = test::RandomSurface(random, 7);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(std::get<SurfaceModel>(MirrorShape(MirrorShape(surface))).Coefficients(axis),
              std::get<SurfaceModel>(surface).Coefficients(axis));
  }
}
} // namespace
} // namespace palpate::shape_mirror_test
