#include "IcosahedronDirections.h"

#include "RandomShapes.h"
#include "WorstCase.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <set>

namespace palpate::icosahedron_directions_test
{
namespace
{
class IcosahedronDirectionsOfFrequency : public testing::TestWithParam<int>
{
protected:
  IcosahedronDirections Sphere{GetParam()};

  const Vector3& Corner(const std::array<int, 3>& face, std::size_t corner) const
  {
    return this->Sphere.Directions()[static_cast<std::size_t>(face[corner])];
  }
};

// Coordinates on a grid far finer than the spacing and far coarser than rounding.
std::array<long long, 3> Rounded(const Vector3& v)
{
  return {std::llround(v.x() * 1e9), std::llround(v.y() * 1e9), std::llround(v.z() * 1e9)};
}

TEST_P(IcosahedronDirectionsOfFrequency, HasExactCounts)
{
  const int f = GetParam();
  EXPECT_EQ(this->Sphere.Frequency(), f);
  EXPECT_EQ(this->Sphere.Directions().size(), static_cast<std::size_t>(10 * f * f + 2));
  EXPECT_EQ(this->Sphere.Triangles().size(), static_cast<std::size_t>(20 * f * f));
}

TEST_P(IcosahedronDirectionsOfFrequency, HasDistinctUnitDirections)
{
  std::set<std::array<long long, 3>> seen;
  for (const Vector3& u : this->Sphere.Directions())
  {
    EXPECT_NEAR(u.norm(), 1.0, 4e-16); // a few roundings
    EXPECT_TRUE(seen.insert(Rounded(u)).second);
  }
}

TEST_P(IcosahedronDirectionsOfFrequency, IsClosedWithConsistentWinding)
{
  std::map<std::pair<int, int>, int> halfEdges;
  for (const auto& face : this->Sphere.Triangles())
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      ++halfEdges[{face[k], face[(k + 1) % 3]}];
    }
  }
  for (const auto& [edge, count] : halfEdges)
  {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(halfEdges.count({edge.second, edge.first}), 1U);
  }
  const auto vertices = static_cast<long long>(this->Sphere.Directions().size());
  const auto edges = static_cast<long long>(halfEdges.size() / 2);
  const auto faces = static_cast<long long>(this->Sphere.Triangles().size());
  EXPECT_EQ(vertices - edges + faces, 2);
}

TEST_P(IcosahedronDirectionsOfFrequency, FacesOutwards)
{
  for (const auto& face : this->Sphere.Triangles())
  {
    const Vector3 normal = (this->Corner(face, 1) - this->Corner(face, 0))
                               .cross(this->Corner(face, 2) - this->Corner(face, 0));
    const Vector3 center = this->Corner(face, 0) + this->Corner(face, 1) + this->Corner(face, 2);
    // Within 20 degrees even for the twenty large faces (where it is exact by symmetry).
    EXPECT_GT(normal.normalized().dot(center.normalized()), 0.94);
  }
}

TEST_P(IcosahedronDirectionsOfFrequency, SolidAnglesCoverSphere)
{
  const std::vector<double> angles = this->Sphere.SolidAngles();
  ASSERT_EQ(angles.size(), this->Sphere.Directions().size());
  const double mean = 4 * M_PI / static_cast<double>(angles.size());
  // Thousands of additions of small numbers: rounding of the sum.
  EXPECT_NEAR(std::accumulate(angles.begin(), angles.end(), 0.0), 4 * M_PI, 1e-11);
  for (const double angle : angles)
  {
    // Projection to the sphere makes triangles near the corners smaller, by a bounded ratio.
    EXPECT_GT(angle, 0.4 * mean);
    EXPECT_LT(angle, 1.6 * mean);
  }
}

TEST_P(IcosahedronDirectionsOfFrequency, IsSymmetricUnderSignsAndRotations)
{
  std::set<std::array<long long, 3>> all;
  for (const Vector3& u : this->Sphere.Directions())
  {
    all.insert(Rounded(u));
  }
  const auto contains = [&all](const Vector3& u)
  {
    // The neighbour on the rounding grid may be the right one.
    for (int shift = 0; shift < 27; ++shift)
    {
      const std::array<long long, 3> r = Rounded(u);
      if (all.count({r[0] + shift % 3 - 1, r[1] + shift / 3 % 3 - 1, r[2] + shift / 9 - 1}) > 0)
      {
        return true;
      }
    }
    return false;
  };
  for (const Vector3& u : this->Sphere.Directions())
  {
    EXPECT_TRUE(contains({-u.x(), u.y(), u.z()}));
    EXPECT_TRUE(contains({u.x(), -u.y(), u.z()}));
    EXPECT_TRUE(contains({u.x(), u.y(), -u.z()}));
    EXPECT_TRUE(contains({u.y(), u.z(), u.x()}));
  }
}

INSTANTIATE_TEST_SUITE_P(From1To30, IcosahedronDirectionsOfFrequency, testing::Range(1, 31));

TEST(IcosahedronDirections, Frequency20Has4002Directions)
{
  const IcosahedronDirections sphere(20);
  EXPECT_EQ(sphere.Directions().size(), 4002U);
  EXPECT_EQ(sphere.Triangles().size(), 8000U);
}

TEST(IcosahedronDirections, InvalidFrequencyGivesIcosahedron)
{
  EXPECT_EQ(IcosahedronDirections(0).Directions().size(), 12U);
  EXPECT_EQ(IcosahedronDirections(-3).Frequency(), 1);
}

TEST(IcosahedronDirections, IcosahedronHasEqualSolidAngles)
{
  for (const double angle : IcosahedronDirections(1).SolidAngles())
  {
    EXPECT_NEAR(angle, 4 * M_PI / 12, 1e-14); // some roundings
  }
}

TEST(IcosahedronDirections, DoubledFrequencyKeepsDirections)
{
  // Every second point of the finer grid is a point of the coarser one: the set grows by nesting.
  const IcosahedronDirections coarse(4);
  const IcosahedronDirections fine(8);
  std::set<std::array<long long, 3>> finePoints;
  for (const Vector3& u : fine.Directions())
  {
    finePoints.insert(Rounded(u));
  }
  for (const Vector3& u : coarse.Directions())
  {
    EXPECT_EQ(finePoints.count(Rounded(u)), 1U);
  }
}

TEST(IcosahedronDirections, LargestGapReachesEveryDirection)
{
  // From a corner of the icosahedron to the centre of a face.
  EXPECT_NEAR(IcosahedronDirections(1).LargestGap(), 0.6523581397843682, 1e-11);
  test::Random random(71);
  for (const int frequency : {1, 2, 5})
  {
    const IcosahedronDirections sphere(frequency);
    const double gap = sphere.LargestGap();
    double farthest = 0.0;
    for (const Vector3& u : test::RandomDirections(random, 3000))
    {
      double nearest = -1.0;
      for (const Vector3& direction : sphere.Directions())
      {
        nearest = std::max(nearest, direction.dot(u));
      }
      farthest = std::max(farthest, std::acos(nearest));
    }
    EXPECT_LE(farthest, gap);
    EXPECT_GE(farthest, 0.9 * gap);
  }
}
} // namespace
} // namespace palpate::icosahedron_directions_test
