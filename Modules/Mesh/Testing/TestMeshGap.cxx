#include "MeshGap.h"

#include "MeshShapes.h"
#include "NearestOnMesh.h"
#include "RandomShapes.h"

#include <gtest/gtest.h>

namespace palpate::mesh_gap_test
{
namespace
{
MeshGap GapOf(const IndexedMesh& one, const IndexedMesh& other)
{
  MeshGap gap;
  const Status status = FindMeshGap(one, other, gap);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return gap;
}

void ExpectOn(const IndexedMesh& mesh, const Vector3& point)
{
  NearestOnMesh nearest;
  ASSERT_TRUE(NearestOnMesh::Make(mesh, nearest).IsOk());
  EXPECT_LT(nearest.Find(point).Distance, 1e-9);
}

TEST(MeshGap, IsThatOfTwoSpheres)
{
  // The spheres have points on the line through their centres.
  const IndexedMesh one = test::Sphere(10, 10.0);
  const Vector3 direction = one.Points[17].normalized();
  IndexedMesh other = test::Sphere(10, 4.0, 20.0 * direction);
  const MeshGap gap = GapOf(one, other);
  // Inscribed: up to (4 + 10) (1 - cos(0.07)) mm more.
  EXPECT_GE(gap.Distance, 6.0 - 1e-9);
  EXPECT_LT(gap.Distance, 6.0 + 0.04);
  EXPECT_NEAR((gap.PointOfOne - gap.PointOfOther).norm(), gap.Distance, 1e-12);
  ExpectOn(one, gap.PointOfOne);
  ExpectOn(other, gap.PointOfOther);
}

// Edge against edge: two boxes turned so that neither has a corner near the other.
TEST(MeshGap, IsExactBetweenEdges)
{
  IndexedMesh one = test::Box(Vector3(-1.0, -5.0, -1.0), Vector3(1.0, 5.0, 1.0));
  IndexedMesh other = test::Box(Vector3(-5.0, -1.0, -1.0), Vector3(5.0, 1.0, 1.0));
  const Eigen::AngleAxisd around(M_PI / 4.0, Vector3::UnitY());
  const Eigen::AngleAxisd across(M_PI / 4.0, Vector3::UnitX());
  for (Vector3& p : one.Points)
  {
    p = around * p;
  }
  for (Vector3& p : other.Points)
  {
    p = across * p + Vector3(0.0, 0.0, 7.0);
  }
  const MeshGap gap = GapOf(one, other);
  EXPECT_NEAR(gap.Distance, 7.0 - 2.0 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(gap.PointOfOne.z(), std::sqrt(2.0), 1e-12);
}

// Points alone: brute force, so never less than the gap.
TEST(MeshGap, IsNoMoreThanFromAnyPointAndSymmetric)
{
  test::Random random(8);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 20; ++i)
  {
    const IndexedMesh one = test::Lobed(6);
    IndexedMesh other = test::Torus(20, 10);
    const Vector3 shift = 12.0 * Vector3(normal(random), normal(random), normal(random));
    for (Vector3& p : other.Points)
    {
      p += shift;
    }
    const MeshGap gap = GapOf(one, other);
    EXPECT_NEAR(gap.Distance, GapOf(other, one).Distance, 1e-12);
    NearestOnMesh nearest;
    ASSERT_TRUE(NearestOnMesh::Make(one, nearest).IsOk());
    double least = std::numeric_limits<double>::infinity();
    for (const Vector3& p : other.Points)
    {
      least = std::min(least, nearest.Find(p).Distance);
    }
    EXPECT_LE(gap.Distance, least + 1e-12);
    EXPECT_GE(gap.Distance, least - 1.0) << "edges of the torus are shorter than 2";
    ExpectOn(one, gap.PointOfOne);
    ExpectOn(other, gap.PointOfOther);
  }
}

TEST(MeshGap, IsZeroWhereSurfacesCross)
{
  const IndexedMesh one = test::Sphere(8, 5.0);
  const IndexedMesh other = test::Sphere(8, 5.0, Vector3(6.0, 0.3, 0.2));
  const MeshGap gap = GapOf(one, other);
  EXPECT_EQ(gap.Distance, 0.0);
  ExpectOn(one, gap.PointOfOne);
  ExpectOn(other, gap.PointOfOther);
}

TEST(MeshGap, IsTheWallBetweenASurfaceAndOneInIt)
{
  const MeshGap gap = GapOf(test::Box(Vector3::Zero(), Vector3::Constant(10.0)),
                            test::Box(Vector3::Constant(2.0), Vector3(8.0, 7.0, 8.5)));
  EXPECT_NEAR(gap.Distance, 1.5, 1e-12);
}

TEST(MeshGap, RefusesMeshesThatAreNone)
{
  MeshGap gap;
  EXPECT_FALSE(FindMeshGap({}, test::Sphere(2), gap).IsOk());
  EXPECT_FALSE(FindMeshGap(test::Sphere(2), {}, gap).IsOk());
}
} // namespace
} // namespace palpate::mesh_gap_test
