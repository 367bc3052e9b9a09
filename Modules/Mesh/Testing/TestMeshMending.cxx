#include "MeshMending.h"

#include "MeshShapes.h"
#include "RandomShapes.h"
#include "SurfaceTopology.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace palpate::mesh_mending_test
{
namespace
{
TEST(MeshMending, WeldsTrianglesOfStlFile)
{
  const IndexedMesh sphere = test::Sphere(6, 10.0, {1, 2, 3});
  IndexedMesh mesh = test::Unwelded(sphere);
  EXPECT_EQ(WeldPoints(mesh), 3 * 720 - 362);
  EXPECT_TRUE(CheckClosedGenusZero(DescribeTopology(mesh)).IsOk());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_EQ(mesh.Points[mesh.Triangles[t][k]], sphere.Points[sphere.Triangles[t][k]]);
    }
  }
}

TEST(MeshMending, WeldsZerosOfEitherSignButNothingElse)
{
  IndexedMesh mesh{{{0.0, 1.0, 0.0}, {-0.0, 1.0, -0.0}, {0.0, std::nextafter(1.0, 2.0), 0.0}}, {}};
  EXPECT_EQ(WeldPoints(mesh), 1);
  ASSERT_EQ(mesh.Points.size(), 2U);
  EXPECT_GT(mesh.Points[1][1], 1.0);
}

TEST(MeshMending, WeldingKeepsFirstOfEachInOrder)
{
  IndexedMesh mesh{{{3, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{4, 2, 3}}};
  EXPECT_EQ(WeldPoints(mesh), 2);
  EXPECT_EQ(mesh.Points, (std::vector<Vector3>{{3, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(mesh.Triangles.front(), (std::array<int, 3>{1, 0, 2}));
}

TEST(MeshMending, MakesSphereOfScrambledTriangles)
{
  test::Random random(21);
  IndexedMesh mesh = test::Unwelded(test::Sphere(5));
  for (auto& t : mesh.Triangles)
  {
    if (random() % 2 == 0)
    {
      std::swap(t[0], t[1]);
    }
  }
  mesh.Triangles.push_back({5, 5, 9});
  mesh.Points.emplace_back(7, 7, 7);
  std::shuffle(mesh.Triangles.begin(), mesh.Triangles.end(), random);
  MeshMends mends;
  ASSERT_TRUE(MendMesh(mesh, 0, mends).IsOk());
  EXPECT_EQ(mends.DroppedTriangles, 1);
  EXPECT_EQ(mends.DroppedPoints, 1);
  EXPECT_EQ(CheckClosedGenusZero(DescribeTopology(mesh)).Message(), "");
}

TEST(MeshMending, KeepsOneOfDuplicatesInWhateverOrderTheirPointsAre)
{
  const IndexedMesh sphere = test::Sphere(5);
  IndexedMesh mesh = sphere;
  for (const std::size_t t : {0U, 7U, 8U})
  {
    const auto [a, b, c] = sphere.Triangles[t];
    mesh.Triangles.push_back({b, c, a});
    mesh.Triangles.push_back({b, a, c});
  }
  MeshMends mends;
  ASSERT_TRUE(MendMesh(mesh, 0, mends).IsOk());
  EXPECT_EQ(mends.Duplicates, 6);
  EXPECT_EQ(mesh.Triangles, sphere.Triangles);
}

TEST(MeshMending, LeavesGoodMeshUnchanged)
{
  const IndexedMesh sphere = test::Sphere(5);
  IndexedMesh mesh = sphere;
  MeshMends mends;
  ASSERT_TRUE(MendMesh(mesh, 1, mends).IsOk());
  EXPECT_EQ(mesh.Points, sphere.Points);
  EXPECT_EQ(mesh.Triangles, sphere.Triangles);
}

TEST(MeshMending, KeepsPartByItsNumberInOrderOfArea)
{
  const IndexedMesh given = test::Join(test::Sphere(9, 1.0, {9, 9, 9}), test::Sphere(3, 5.0));
  IndexedMesh mesh = given;
  EXPECT_EQ(KeepPart(mesh, 1), 1);
  DropUnusedPoints(mesh);
  EXPECT_EQ(mesh.Points, test::Sphere(3, 5.0).Points);
  mesh = given;
  EXPECT_EQ(KeepPart(mesh, 2), 1);
  DropUnusedPoints(mesh);
  EXPECT_EQ(mesh.Points, test::Sphere(9, 1.0, {9, 9, 9}).Points);
  mesh = given;
  MeshMends mends;
  EXPECT_FALSE(MendMesh(mesh, 3, mends).IsOk());
}

TEST(MeshMending, CavityKeepsFacingInwards)
{
  IndexedMesh mesh =
      test::Reversed(test::Join(test::Sphere(4, 3.0), test::Reversed(test::Sphere(4, 1.0))));
  EXPECT_EQ(OrientOutwards(mesh), 2 * 20 * 16);
  const double hollow = DescribeTopology(mesh).Volume;
  const double outer = DescribeTopology(test::Sphere(4, 3.0)).Volume;
  EXPECT_NEAR(hollow, outer * 26.0 / 27.0, 1e-9);
}

TEST(MeshMending, BodyBesideTheLargestTurnsOutwardsWithItsCavity)
{
  const auto hollow = [](double outer, double inner, const Vector3& center)
  {
    return test::Join(test::Sphere(4, outer, center),
                      test::Reversed(test::Sphere(4, inner, center)));
  };
  // The first has a body in its cavity; the last overlaps it.
  const IndexedMesh bodies[] = {test::Join(hollow(6.0, 5.0, {0, 0, 0}), test::Sphere(4, 3.0)),
                                hollow(2.0, 1.0, {9, 0, 0}), test::Sphere(4, 2.5, {5.5, 5.5, 0})};
  for (unsigned turned = 0; turned < 8; ++turned)
  {
    IndexedMesh mesh;
    double volume = 0.0;
    unsigned bit = turned;
    for (const IndexedMesh& body : bodies)
    {
      mesh = test::Join(mesh, bit % 2 == 1 ? test::Reversed(body) : body);
      volume += DescribeTopology(body).Volume;
      bit /= 2;
    }
    OrientOutwards(mesh);
    EXPECT_NEAR(DescribeTopology(mesh).Volume, volume, 1e-9) << turned;
  }
}

TEST(MeshMending, SmallAndOpenSheetsFollowTheLargest)
{
  IndexedMesh open = test::Sphere(4, 3.0, {9, 0, 0});
  open.Triangles.pop_back();
  for (const IndexedMesh& other : {test::Sphere(4, 0.5, {9, 0, 0}), open})
  {
    IndexedMesh mesh = test::Join(test::Sphere(4, 4.0), test::Reversed(other));
    EXPECT_EQ(OrientOutwards(mesh), 0);
  }
}

TEST(MeshMending, CavitiesOfOpenAndSmallBodiesStay)
{
  IndexedMesh open = test::Sphere(4, 4.0, {12, 0, 0});
  open.Triangles.pop_back();
  const IndexedMesh small =
      test::Join(test::Sphere(4, 1.0, {0, 9, 0}), test::Reversed(test::Sphere(4, 0.5, {0, 9, 0})));
  // The last cavity touches the wall around it and sticks out by a little.
  const IndexedMesh cavities = test::Join(test::Reversed(test::Sphere(4, 3.0, {12, 0, 0})),
                                          test::Reversed(test::Sphere(4, 3.0, {3.1, 0, 0})));
  IndexedMesh mesh =
      test::Join(test::Join(test::Sphere(4, 6.0), open), test::Join(small, cavities));
  EXPECT_EQ(OrientOutwards(mesh), 0);
}

// A wall that is thin against the body's box.
TEST(MeshMending, LumenOfACoiledTubeStays)
{
  const auto tube = [](double radius)
  {
    IndexedMesh mesh = test::Torus(400, 12, 40.0, radius);
    for (Vector3& point : mesh.Points)
    {
      const double angle = std::atan2(point.y(), point.x());
      point.z() += 60.0 * std::sin(5.0 * angle);
    }
    return mesh;
  };
  IndexedMesh mesh = test::Join(tube(1.0), test::Reversed(tube(0.8)));
  EXPECT_EQ(OrientOutwards(mesh), 0);
}

TEST(MeshMending, SheetsOfHugeCoordinatesAreLeftInPeace)
{
  IndexedMesh mesh = test::Join(test::Sphere(4, 1e200), test::Sphere(4, 1e200, {3e200, 0, 0}));
  OrientOutwards(mesh);
  EXPECT_EQ(mesh.Triangles.size(), 2U * 20U * 16U);
}

TEST(MeshMending, ReversesOnlyTheMinority)
{
  for (const std::size_t turned : {0U, 17U})
  {
    IndexedMesh mesh = test::Sphere(4);
    std::swap(mesh.Triangles[turned][0], mesh.Triangles[turned][1]);
    EXPECT_EQ(OrientOutwards(mesh), 1);
    EXPECT_EQ(CheckClosedGenusZero(DescribeTopology(mesh)).Message(), "");
  }
  // An open sheet has no outside; its majority decides alone, volumes of a plane being zero.
  IndexedMesh sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}},
                    {{0, 2, 1}, {0, 2, 3}, {1, 4, 2}}};
  EXPECT_EQ(OrientOutwards(sheet), 1);
  EXPECT_EQ(sheet.Triangles.front(), (std::array<int, 3>{0, 1, 2}));
}

TEST(MeshMending, LeavesOneSidedSurface)
{
  IndexedMesh strip = test::MoebiusStrip(9);
  EXPECT_EQ(OrientOutwards(strip), 0);
  EXPECT_EQ(strip.Triangles, test::MoebiusStrip(9).Triangles);
}

TEST(MeshMending, RejectsBadInputUnchanged)
{
  MeshMends mends;
  IndexedMesh mesh = test::Unwelded(test::Sphere(2));
  mesh.Triangles[3][1] = 1000;
  EXPECT_FALSE(MendMesh(mesh, 0, mends).IsOk());
  EXPECT_EQ(mesh.Points.size(), 240U);
  mesh.Triangles[3][1] = 1;
  mesh.Points[3][1] = INFINITY;
  EXPECT_FALSE(MendMesh(mesh, 0, mends).IsOk());
  IndexedMesh empty;
  EXPECT_TRUE(MendMesh(empty, 1, mends).IsOk());
}
} // namespace
} // namespace palpate::mesh_mending_test
