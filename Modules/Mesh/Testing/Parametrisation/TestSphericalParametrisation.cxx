#include "SphericalParametrisation.h"

#include "ClosedMeshes.h"
#include "RandomOrientation.h"
#include "WorstCase.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::spherical_parametrisation_test
{
namespace
{
using test::Random;
using test::WorstCase;

SphericalParametrisation MapOf(const IndexedMesh& mesh)
{
  SphericalParametrisation result;
  const Status status = ParametriseOnSphere(mesh, {}, result);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return result;
}

// Independent of the kernel's own check: solid angles by l'Huilier's theorem, signs by the plain
// determinant.
bool IsOneToOne(const IndexedMesh& mesh, const std::vector<Vector3>& directions)
{
  double sum = 0.0;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const auto at = [&](std::size_t i) { return directions[static_cast<std::size_t>(t[i])]; };
    const auto arc = [](const Vector3& p, const Vector3& q)
    { return 2.0 * std::asin(std::min(1.0, 0.5 * (p - q).norm())); };
    const double a = arc(at(1), at(2));
    const double b = arc(at(2), at(0));
    const double c = arc(at(0), at(1));
    const double s = 0.5 * (a + b + c);
    const double product = std::tan(0.5 * s) * std::tan(0.5 * (s - a)) * std::tan(0.5 * (s - b)) *
                           std::tan(0.5 * (s - c));
    sum += 4.0 * std::atan(std::sqrt(std::max(0.0, product)));
    if (!(at(0).dot(at(1).cross(at(2))) > 0.0))
    {
      return false;
    }
  }
  // Rounding of thin triangles in l'Huilier's product.
  return std::abs(sum - 4.0 * M_PI) <= 1e-5;
}

double LargestDifference(const std::vector<Vector3>& a, const std::vector<Vector3>& b)
{
  WorstCase worst;
  worst.Add(a.size() == b.size() ? 0.0 : std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
  {
    worst.Add((a[i] - b[i]).norm());
  }
  return worst.Value();
}

std::string MessageFor(const IndexedMesh& mesh)
{
  SphericalParametrisation result;
  return ParametriseOnSphere(mesh, {}, result).Message();
}

TEST(SphericalParametrisation, StarShapedMeshesMapOneToOne)
{
  Random random(1);
  for (int trial = 0; trial < 30; ++trial)
  {
    const IndexedMesh mesh = test::RandomStarMesh(random, 3 + trial % 8);
    EXPECT_TRUE(IsOneToOne(mesh, MapOf(mesh).Directions)) << trial;
  }
}

TEST(SphericalParametrisation, BentAndSpikedMeshesMapOneToOne)
{
  for (const double angle : {0.5, 2.0, 4.7})
  {
    for (const double length : {3.0, 8.0})
    {
      const IndexedMesh mesh = test::BentMesh(10, length, angle);
      EXPECT_TRUE(IsOneToOne(mesh, MapOf(mesh).Directions)) << angle << ' ' << length;
    }
  }
  for (const double height : {0.5, 2.0, 6.0})
  {
    const IndexedMesh mesh = test::SpikedMesh(14, height);
    EXPECT_TRUE(IsOneToOne(mesh, MapOf(mesh).Directions)) << height;
  }
}

TEST(SphericalParametrisation, DirectionsAreUnitVectors)
{
  WorstCase worst;
  for (const Vector3& u : MapOf(test::SpikedMesh(8, 2.0)).Directions)
  {
    worst.Add(u.norm() - 1.0);
  }
  EXPECT_LE(worst.Value(), 1e-15); // rounding
}

// The map of least energy is the sphere itself; sweeps end a little before.
TEST(SphericalParametrisation, SphereKeepsItsAreas)
{
  const SphereMapQuality quality = MapOf(test::SphereMesh(16)).Quality;
  EXPECT_LE(quality.AreaDistortion, 0.02);
  EXPECT_GE(quality.LeastRatio, 0.9);
  EXPECT_LE(quality.LargestRatio, 1.1);
}

TEST(SphericalParametrisation, EllipsoidOf1To2IsMappedWithLittleDistortion)
{
  const IndexedMesh mesh = test::ClosedMesh(14, [](const Vector3& u)
                                            { return Vector3(u.x(), 1.5 * u.y(), 2.0 * u.z()); });
  EXPECT_LE(MapOf(mesh).Quality.AreaDistortion, 0.06);
}

TEST(SphericalParametrisation, RotatedMovedAndScaledMeshesHaveTheSameMap)
{
  Random random(2);
  WorstCase worst;
  for (int trial = 0; trial < 10; ++trial)
  {
    const IndexedMesh mesh = test::RandomStarMesh(random, 9);
    const Matrix3 turn = test::RandomOrientation(random);
    const double scale = trial % 2 == 0 ? 1e-3 : 40.0;
    const IndexedMesh copy = test::Moved(mesh, scale * turn, scale * Vector3(30.0, -200.0, 70.0));
    worst.Add(LargestDifference(MapOf(mesh).Directions, MapOf(copy).Directions));
  }
  // The copies' edges differ by some 1e-14; sweeps stop before they converge and amplify that.
  EXPECT_LE(worst.Value(), 1e-6);
}

TEST(SphericalParametrisation, IsDeterministic)
{
  Random random(3);
  const IndexedMesh mesh = test::RandomStarMesh(random, 10);
  EXPECT_EQ(MapOf(mesh).Directions, MapOf(mesh).Directions);
}

TEST(SphericalParametrisation, MirroredMeshHasTheMirroredMap)
{
  Random random(4);
  WorstCase worst;
  for (int trial = 0; trial < 10; ++trial)
  {
    const IndexedMesh mesh = test::RandomStarMesh(random, 9);
    std::vector<Vector3> mirrored = MapOf(test::MirroredMesh(mesh)).Directions;
    for (Vector3& u : mirrored)
    {
      u.z() = -u.z();
    }
    worst.Add(LargestDifference(MapOf(mesh).Directions, mirrored));
  }
  EXPECT_LE(worst.Value(), 1e-6); // sums in another order; as for rotated meshes
}

TEST(SphericalParametrisation, NumberingDoesNotChangeTheQuality)
{
  Random random(5);
  for (int trial = 0; trial < 10; ++trial)
  {
    const IndexedMesh mesh = test::RandomStarMesh(random, 9);
    const IndexedMesh other = test::Renumbered(mesh, random);
    const SphereMapQuality quality = MapOf(mesh).Quality;
    const SphericalParametrisation map = MapOf(other);
    EXPECT_TRUE(IsOneToOne(other, map.Directions));
    // Sweeps in another order end at another distance from the minimum.
    EXPECT_NEAR(map.Quality.AreaDistortion, quality.AreaDistortion,
                0.01 + 0.1 * quality.AreaDistortion);
  }
}

TEST(SphericalParametrisation, SliversAndNeedleTrianglesMapOneToOne)
{
  for (const double height : {1e-2, 1e-4, 1e-6, 1e-8})
  {
    IndexedMesh mesh = test::SphereMesh(8);
    // A few vertices, no two of them in one triangle, next to a neighbour or to the opposite edge.
    for (const std::size_t i : {3U, 101U, 205U, 307U, 410U, 533U, 702U, 901U, 1111U})
    {
      const std::array<int, 3>& t = mesh.Triangles[i];
      Vector3& p = mesh.Points[static_cast<std::size_t>(t[0])];
      const Vector3 a = mesh.Points[static_cast<std::size_t>(t[1])];
      const Vector3 b = mesh.Points[static_cast<std::size_t>(t[2])];
      const Vector3 foot = i % 2 == 0 ? a : Vector3(0.5 * (a + b));
      p = foot + height * (p - foot);
    }
    SphericalParametrisation map;
    const Status status = ParametriseOnSphere(mesh, {}, map);
    ASSERT_TRUE(status.IsOk()) << height << status.Message();
    EXPECT_TRUE(IsBijective(mesh.Triangles, map.Directions)) << height;
  }
}

TEST(SphericalParametrisation, SmallestMeshesMapOneToOne)
{
  for (const IndexedMesh& mesh : {test::TetrahedronMesh(), test::Bipyramid(3), test::Bipyramid(4),
                                  test::Bipyramid(5), test::SphereMesh(1)})
  {
    EXPECT_TRUE(IsOneToOne(mesh, MapOf(mesh).Directions)) << mesh.Points.size();
  }
}

// Two vertices with all others as neighbours: time stays bounded.
TEST(SphericalParametrisation, VerticesWithThousandsOfNeighboursMapOneToOne)
{
  const IndexedMesh mesh = test::Bipyramid(3000);
  EXPECT_TRUE(IsBijective(mesh.Triangles, MapOf(mesh).Directions));
}

TEST(SphericalParametrisation, ReportsTheDistortionOfALongRod)
{
  const IndexedMesh mesh =
      test::ClosedMesh(12, [](const Vector3& u) { return Vector3(u.x(), u.y(), 60.0 * u.z()); });
  const SphereMapQuality quality = MapOf(mesh).Quality;
  EXPECT_GE(quality.AreaDistortion, 0.3);
  EXPECT_LE(quality.LeastRatio, 0.5);
  EXPECT_GE(quality.LargestRatio, 2.0);
}

TEST(SphericalParametrisation, RejectsSurfacesThatAreNotClosed)
{
  IndexedMesh open = test::SphereMesh(3);
  open.Triangles.pop_back();
  EXPECT_NE(MessageFor(open), "");
  // The right number of triangles, but one covers another and leaves a hole.
  IndexedMesh doubled = test::SphereMesh(3);
  doubled.Triangles.back() = doubled.Triangles.front();
  EXPECT_NE(MessageFor(doubled), "");
  EXPECT_NE(MessageFor({}), "");
}

TEST(SphericalParametrisation, RejectsInconsistentOrientation)
{
  IndexedMesh mesh = test::SphereMesh(3);
  std::swap(mesh.Triangles[7][0], mesh.Triangles[7][1]);
  EXPECT_NE(MessageFor(mesh), "");
}

TEST(SphericalParametrisation, RejectsHandlesAndSeveralParts)
{
  const IndexedMesh sphere = test::SphereMesh(2);
  const IndexedMesh torus = test::TorusMesh(12, 7);
  EXPECT_NE(MessageFor(torus), "");
  EXPECT_NE(MessageFor(test::Union(sphere, sphere)), "");
  // Euler's number 2 + 0 is that of one sphere.
  EXPECT_NE(MessageFor(test::Union(sphere, torus)), "");
}

TEST(SphericalParametrisation, RejectsBadIndices)
{
  for (const int bad : {-1, 12, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()})
  {
    IndexedMesh mesh = test::SphereMesh(1);
    mesh.Triangles[3][1] = bad;
    EXPECT_NE(MessageFor(mesh), "") << bad;
  }
  IndexedMesh repeated = test::SphereMesh(1);
  repeated.Triangles[3][1] = repeated.Triangles[3][0];
  EXPECT_NE(MessageFor(repeated), "");
}

TEST(SphericalParametrisation, RejectsPointsThatAreNotFinite)
{
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e308})
  {
    IndexedMesh mesh = test::SphereMesh(2);
    mesh.Points[5].y() = bad;
    mesh.Points[6].y() = -bad;
    EXPECT_NE(MessageFor(mesh), "") << bad;
  }
}

TEST(SphericalParametrisation, RejectsTrianglesWithoutArea)
{
  IndexedMesh same = test::SphereMesh(2);
  same.Points[5] = same.Points[static_cast<std::size_t>(same.Triangles[0][0])];
  same.Points[static_cast<std::size_t>(same.Triangles[0][1])] = same.Points[5];
  EXPECT_NE(MessageFor(same), "");
  const IndexedMesh point =
      test::ClosedMesh(2, [](const Vector3&) { return Vector3(1.0, 2.0, 3.0); });
  EXPECT_NE(MessageFor(point), "");
  const IndexedMesh line =
      test::ClosedMesh(2, [](const Vector3& u) { return Vector3(u.x(), 0.0, 0.0); });
  EXPECT_NE(MessageFor(line), "");
}

TEST(SphericalParametrisation, FailureLeavesTheResult)
{
  SphericalParametrisation result;
  result.Directions = {Vector3::UnitX()};
  EXPECT_FALSE(ParametriseOnSphere(test::TorusMesh(5, 5), {}, result).IsOk());
  EXPECT_EQ(result.Directions, std::vector<Vector3>{Vector3::UnitX()});
}

TEST(SphericalParametrisation, ProgressGrowsToOne)
{
  std::vector<double> fractions;
  SphericalParametrisation result;
  const auto progress = [&](double fraction)
  {
    fractions.push_back(fraction);
    return true;
  };
  ASSERT_TRUE(ParametriseOnSphere(test::SphereMesh(18), progress, result).IsOk());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GE(fractions.front(), 0.0);
  EXPECT_EQ(fractions.back(), 1.0);
}

TEST(SphericalParametrisation, CancelsAtEveryReport)
{
  int reports = 0;
  SphericalParametrisation result;
  const IndexedMesh mesh = test::SphereMesh(11);
  const auto count = [&](double)
  {
    ++reports;
    return true;
  };
  ASSERT_TRUE(ParametriseOnSphere(mesh, count, result).IsOk());
  for (int at = 1; at <= reports; ++at)
  {
    result = {};
    int seen = 0;
    const auto cancel = [&](double) { return ++seen < at; };
    EXPECT_FALSE(ParametriseOnSphere(mesh, cancel, result).IsOk());
    EXPECT_EQ(seen, at);
    EXPECT_TRUE(result.Directions.empty());
  }
}
} // namespace
} // namespace palpate::spherical_parametrisation_test
