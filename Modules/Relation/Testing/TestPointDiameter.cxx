#include "PointDiameter.h"

#include "MeshShapes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace palpate::point_diameter_test
{
namespace
{
double BruteForce(const std::vector<Vector3>& points)
{
  double largest = 0.0;
  for (const Vector3& one : points)
  {
    for (const Vector3& other : points)
    {
      largest = std::max(largest, (one - other).norm());
    }
  }
  return largest;
}

TEST(PointDiameter, OfSurfacesIsTheLargestDistance)
{
  for (const IndexedMesh& mesh : {test::Sphere(12, 5.0), test::Torus(40, 20), test::Lobed(12),
                                  test::Box(Vector3(1.0, 2.0, 3.0), Vector3(4.0, 9.0, 5.0))})
  {
    EXPECT_DOUBLE_EQ(DiameterOf(mesh.Points), BruteForce(mesh.Points));
  }
}

TEST(PointDiameter, OfCloudsIsTheLargestDistance)
{
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int count = 1; count < 600; count += 23)
  {
    std::vector<Vector3> points;
    for (int i = 0; i < count; ++i)
    {
      points.emplace_back(normal(random), normal(random), normal(random));
    }
    EXPECT_GE(DiameterOf(points), 0.9967 * BruteForce(points));
  }
  EXPECT_EQ(DiameterOf({}), 0.0);
}
} // namespace
} // namespace palpate::point_diameter_test
