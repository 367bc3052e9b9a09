#include "ClosestPointDistances.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace palpate::closest_point_distances_test
{
namespace
{

// A ring about z, of radius 20 and 6 mm: no point sees all of it.
palpate::IndexedMesh Ring(int steps)
{
  palpate::IndexedMesh mesh;
  for (int u = 0; u < steps; ++u)
  {
    for (int v = 0; v < steps; ++v)
    {
      const double a = 2.0 * M_PI * u / steps;
      const double b = 2.0 * M_PI * v / steps;
      const double r = 20.0 + 6.0 * std::cos(b);
      mesh.Points.emplace_back(r * std::cos(a), r * std::sin(a), 6.0 * std::sin(b));
      const int nextU = (u + 1) % steps;
      const int nextV = (v + 1) % steps;
      mesh.Triangles.push_back({u * steps + v, nextU * steps + v, nextU * steps + nextV});
      mesh.Triangles.push_back({u * steps + v, nextU * steps + nextV, u * steps + nextV});
    }
  }
  return mesh;
}

TEST(SignedDistances, OfRingAreKnown)
{
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> uniform(-30.0, 30.0);
  std::vector<Vector3> points{Vector3::Zero()};
  for (int i = 0; i < 500; ++i)
  {
    points.emplace_back(uniform(random), uniform(random), 0.3 * uniform(random));
  }
  const std::vector<double> distances = palpate::SignedDistances(points, Ring(200));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vector3& p = points[i];
    const double exact = std::hypot(std::hypot(p.x(), p.y()) - 20.0, p.z()) - 6.0;
    // Chords of 2 pi 26 / 200 mm lie within 3 micrometres of their arc, those of the tube closer.
    EXPECT_NEAR(distances[i], exact, 0.004) << p.transpose();
  }
}

TEST(SignedDistances, AreNanForSurfaceThatIsNotFinite)
{
  palpate::IndexedMesh ring = Ring(8);
  ring.Points[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(palpate::SignedDistances({Vector3::Zero()}, ring).front()));
  EXPECT_TRUE(std::isnan(palpate::SignedDistances({Vector3::Zero()}, {}).front()));
}
} // namespace
} // namespace palpate::closest_point_distances_test
