#include "MeshDecimation.h"

#include "MeshCrossings.h"
#include "MeshDistances.h"
#include "MeshShapes.h"
#include "RandomShapes.h"
#include "SurfaceTopology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace palpate::mesh_decimation_test
{
namespace
{
IndexedMesh Decimated(const IndexedMesh& mesh, int triangles, const ReferenceNormal& normal = {},
                      int rounds = 3)
{
  IndexedMesh decimated;
  EXPECT_EQ(DecimateMesh(mesh, {triangles, rounds}, normal, {}, decimated).Message(), "");
  return decimated;
}

// Some triangles get a point next to an edge, and so two needles with arbitrary normals.
IndexedMesh WithNeedles(IndexedMesh mesh, double height)
{
  test::Random random(61);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const std::size_t count = mesh.Triangles.size();
  for (std::size_t t = 0; t < count; t += 2)
  {
    const auto [a, b, c] = mesh.Triangles[t];
    const int point = static_cast<int>(mesh.Points.size());
    const Vector3 step(uniform(random), uniform(random), uniform(random));
    mesh.Points.push_back(0.49 * mesh.Points[a] + 0.509 * mesh.Points[b] + 0.001 * mesh.Points[c] +
                          height * step);
    mesh.Triangles[t] = {a, b, point};
    mesh.Triangles.push_back({b, c, point});
    mesh.Triangles.push_back({c, a, point});
  }
  return mesh;
}

double SmallestAngle(const IndexedMesh& mesh)
{
  double least = M_PI;
  for (const auto& t : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vector3& a = mesh.Points[t[k]];
      const Vector3 ab = mesh.Points[t[(k + 1) % 3]] - a;
      const Vector3 ac = mesh.Points[t[(k + 2) % 3]] - a;
      least = std::min(least, std::atan2(ab.cross(ac).norm(), ab.dot(ac)));
    }
  }
  return least;
}

void ExpectSameTopology(const IndexedMesh& one, const IndexedMesh& other)
{
  const SurfaceTopology before = DescribeTopology(one);
  const SurfaceTopology after = DescribeTopology(other);
  EXPECT_EQ(after.Parts, before.Parts);
  EXPECT_EQ(after.EulerCharacteristic, before.EulerCharacteristic);
  EXPECT_EQ(after.Holes + after.NonManifoldEdges + after.PinchedPoints + after.UnusedPoints +
                after.OrientationConflicts + after.DuplicateTriangles,
            0);
}

TEST(MeshDecimation, KeepsTopologyVolumeAndShape)
{
  const IndexedMesh body = test::Lobed(40);
  const IndexedMesh coarse = Decimated(body, 3000);
  EXPECT_EQ(coarse.Triangles.size(), 3000U);
  ExpectSameTopology(body, coarse);
  EXPECT_NEAR(DescribeTopology(coarse).Volume / DescribeTopology(body).Volume, 1.0, 1e-3);
  MeshDistances distances;
  ASSERT_TRUE(MeasureMeshDistances(coarse, body, distances).IsOk());
  // Edges of some 2 mm on radii of curvature of some 5 mm at the lobes: a sagitta of 0.1 mm.
  EXPECT_LT(distances.Both.Mean, 0.05);
  EXPECT_LT(distances.Both.Largest, 0.4);
}

TEST(MeshDecimation, KeepsHandlesAndParts)
{
  const IndexedMesh ring = test::Torus(80, 40);
  ExpectSameTopology(ring, Decimated(ring, 600));
  const IndexedMesh parts = test::Join(ring, test::Sphere(12, 0.5));
  ExpectSameTopology(parts, Decimated(parts, 500));
}

TEST(MeshDecimation, CollapsesEverySphereToTetrahedronAtMost)
{
  const IndexedMesh body = test::Lobed(6);
  const IndexedMesh least = Decimated(body, 4);
  ExpectSameTopology(body, least);
  EXPECT_LE(least.Triangles.size(), 40U);
  const IndexedMesh tetrahedron = test::Tetrahedron({0, 0, 0}, 1.0);
  EXPECT_EQ(Decimated(tetrahedron, 4).Triangles.size(), 4U);
  ExpectSameTopology(test::Torus(9, 9), Decimated(test::Torus(9, 9), 4));
}

TEST(MeshDecimation, LeavesTrianglesOfGoodShape)
{
  const IndexedMesh coarse = Decimated(test::Lobed(50), 5000);
  // Measured 28 degrees; real organs 17 and more.
  EXPECT_GT(SmallestAngle(coarse), 0.3);
}

TEST(MeshDecimation, RemovesNeedlesThatFaceAnyDirection)
{
  const IndexedMesh body = test::Lobed(30);
  const IndexedMesh rough = WithNeedles(body, 0.002);
  const ReferenceNormal outwards = [](const Vector3& p) { return p; };
  for (const ReferenceNormal& normal : {ReferenceNormal(), outwards})
  {
    const IndexedMesh coarse = Decimated(rough, 4000, normal);
    EXPECT_EQ(coarse.Triangles.size(), 4000U);
    EXPECT_GT(SmallestAngle(coarse), 0.3);
    MeshCrossings crossings;
    ASSERT_TRUE(FindMeshCrossings(coarse, {}, crossings).IsOk());
    EXPECT_EQ(crossings.Count, 0);
  }
}

TEST(MeshDecimation, TurnsNoTriangleOfStarShapeOver)
{
  const IndexedMesh coarse = Decimated(test::Lobed(40), 2000);
  for (const auto& t : coarse.Triangles)
  {
    const Vector3& a = coarse.Points[t[0]];
    const Vector3 normal = (coarse.Points[t[1]] - a).cross(coarse.Points[t[2]] - a).normalized();
    EXPECT_GT(normal.dot(a.normalized()), 0.2);
  }
}

TEST(MeshDecimation, KeepsVolumeOfCollapsesToRounding)
{
  const IndexedMesh body = test::Lobed(20);
  const IndexedMesh coarse = Decimated(body, 1000, {}, 0);
  EXPECT_NEAR(DescribeTopology(coarse).Volume / DescribeTopology(body).Volume, 1.0, 1e-12);
}

TEST(MeshDecimation, IsDeterministicAndMayReplaceItsInput)
{
  IndexedMesh mesh = test::Lobed(20);
  const IndexedMesh coarse = Decimated(mesh, 1000);
  ASSERT_TRUE(DecimateMesh(mesh, {1000, 3}, {}, {}, mesh).IsOk());
  EXPECT_EQ(mesh.Points, coarse.Points);
  EXPECT_EQ(mesh.Triangles, coarse.Triangles);
}

TEST(MeshDecimation, UnusableReferenceNormalsDoNoHarm)
{
  const IndexedMesh body = test::Lobed(20);
  for (const double value :
       {0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    const IndexedMesh coarse =
        Decimated(body, 1000, [value](const Vector3&) { return Vector3(value, value, value); });
    EXPECT_EQ(coarse.Triangles.size(), 1000U);
    ExpectSameTopology(body, coarse);
  }
}

TEST(MeshDecimation, ReportsProgressAndCanBeCancelled)
{
  const IndexedMesh body = test::Lobed(40);
  double last = 0.0;
  IndexedMesh coarse;
  const auto report = [&last](double fraction)
  {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.0);
    last = fraction;
    return true;
  };
  ASSERT_TRUE(DecimateMesh(body, {1000, 3}, {}, report, coarse).IsOk());
  EXPECT_GT(last, 0.5);
  IndexedMesh none;
  EXPECT_FALSE(DecimateMesh(
                   body, {1000, 3}, {}, [](double) { return false; }, none)
                   .IsOk());
  EXPECT_TRUE(none.Triangles.empty());
}

TEST(MeshDecimation, RejectsWhatIsNoClosedManifold)
{
  IndexedMesh coarse;
  const auto isRejected = [&coarse](const IndexedMesh& mesh) {
    return !DecimateMesh(mesh, {100, 3}, {}, {}, coarse).IsOk() && coarse.Triangles.empty();
  };
  IndexedMesh open = test::Sphere(4);
  open.Triangles.pop_back();
  EXPECT_TRUE(isRejected(open));
  IndexedMesh turned = test::Sphere(4);
  std::swap(turned.Triangles[5][0], turned.Triangles[5][1]);
  EXPECT_TRUE(isRejected(turned));
  IndexedMesh pinched = test::Join(test::Sphere(4), test::Sphere(4, 1.0, {3, 0, 0}));
  for (auto& t : pinched.Triangles)
  {
    std::replace(t.begin(), t.end(), 162, 0); // one point of each
  }
  EXPECT_TRUE(isRejected(pinched));
  EXPECT_TRUE(isRejected(test::MoebiusStrip(9)));
  IndexedMesh bad = test::Sphere(4);
  bad.Points[3][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(isRejected(bad));
  bad = test::Sphere(4);
  bad.Triangles[3][0] = 1000;
  EXPECT_TRUE(isRejected(bad));
  EXPECT_FALSE(DecimateMesh(test::Sphere(4), {3, 3}, {}, {}, coarse).IsOk());
}

// A flat bar with three edges: below, points of the middle edge lie between those of the outer two,
// which are joined above, so that a flip would join them a second time.
TEST(MeshDecimation, FlipsDoNotJoinPointsTwice)
{
  IndexedMesh bar;
  constexpr int Steps = 6;
  for (int i = 0; i < Steps; ++i)
  {
    const int last = 3 * i; // middle, left, right
    bar.Points.emplace_back(0.0, -0.2, 3.0 * i);
    bar.Points.emplace_back(-1.0, 0.0, 3.0 * i + 1.5);
    bar.Points.emplace_back(1.0, 0.0, 3.0 * i + 1.5);
    bar.Triangles.insert(bar.Triangles.end(),
                         {{last, last + 3, last + 1}, {last, last + 2, last + 3}});
    if (i + 1 < Steps)
    {
      bar.Triangles.insert(bar.Triangles.end(), {{last + 3, last + 4, last + 1},
                                                 {last + 3, last + 2, last + 5},
                                                 {last + 1, last + 4, last + 5},
                                                 {last + 1, last + 5, last + 2}});
    }
  }
  constexpr int End = 3 * Steps;
  bar.Points.emplace_back(0.0, -0.2, 3.0 * Steps);
  bar.Triangles.insert(bar.Triangles.end(), {{0, 1, 2}, {End, End - 1, End - 2}});
  ASSERT_EQ(CheckClosedGenusZero(DescribeTopology(bar)).Message(), "");
  const ReferenceNormal down = [](const Vector3&) { return Vector3(0, -1, 0); };
  ExpectSameTopology(bar, Decimated(bar, 1000, down));
}

TEST(MeshDecimation, PointsWithManyTrianglesAreNotSlow)
{
  const IndexedMesh cone = test::DoubleCone(50'000); // minutes, were it quadratic
  const IndexedMesh coarse = Decimated(cone, 1000);
  ExpectSameTopology(cone, coarse);
  EXPECT_LE(coarse.Triangles.size(), 1000U);
}

TEST(MeshDecimation, CopesWithFlatAndCoincidentPoints)
{
  // Closed, but without volume, and with all points in few places.
  IndexedMesh mesh = test::Sphere(10);
  for (Vector3& p : mesh.Points)
  {
    p[2] = 0.0;
  }
  ExpectSameTopology(mesh, Decimated(mesh, 200));
  for (Vector3& p : mesh.Points)
  {
    p = Vector3(std::round(p[0]), 0.0, 0.0);
  }
  ExpectSameTopology(mesh, Decimated(mesh, 200));
}
} // namespace
} // namespace palpate::mesh_decimation_test
