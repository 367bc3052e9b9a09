#include "PointMeasures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::point_measures_test
{
namespace
{
TEST(PointMeasures, AngleIsAccurateAtBothEnds)
{
  const Vector3 vertex(1.0, 2.0, 3.0);
  for (const double angle : {0.0, 1e-9, 1e-3, M_PI / 3.0, M_PI / 2.0, M_PI - 1e-9, M_PI})
  {
    const Vector3 other(std::cos(angle), std::sin(angle), 0.0);
    EXPECT_NEAR(AngleAt(vertex, vertex + 5.0 * Vector3::UnitX(), vertex + 0.2 * other), angle,
                1e-14);
  }
  EXPECT_EQ(AngleAt(vertex, vertex, Vector3::Zero()), 0.0);
}

TEST(PointMeasures, LineHasLengthAndMiddle)
{
  const std::vector<Vector3> line{
      {0.0, 0.0, 0.0}, {3.0, 4.0, 0.0}, {3.0, 4.0, 0.0}, {3.0, 4.0, 15.0}};
  EXPECT_EQ(PolylineLength(line), 20.0);
  EXPECT_EQ(PolylineMiddle(line), Vector3(3.0, 4.0, 5.0));
  EXPECT_EQ(PolylineLength({line[1]}), 0.0);
  EXPECT_EQ(PolylineMiddle({line[1]}), line[1]);
}

TEST(PointMeasures, PlaneHasRightHandedNormalUnlessOnALine)
{
  const Vector3 origin(4.0, 5.0, 6.0);
  EXPECT_EQ(PlaneNormal(origin, origin + Vector3::UnitX(), origin + 7.0 * Vector3::UnitY()),
            Vector3::UnitZ());
  EXPECT_EQ(PlaneNormal(origin, origin + Vector3::UnitX(), origin + 2.0 * Vector3::UnitX()),
            Vector3::Zero());
}
} // namespace
} // namespace palpate::point_measures_test
