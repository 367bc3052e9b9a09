#include "StarShape.h"

#include "MeshShapes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::star_shape_test
{
namespace
{

// An L of square cross-section: arms of 30 mm along x and y, 10 mm thick, as its outline in x and y
// extruded along z.
IndexedMesh LShape()
{
  const double outline[6][2] = {{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 30}, {0, 30}};
  IndexedMesh mesh;
  for (const double z : {0.0, 10.0})
  {
    for (const auto& corner : outline)
    {
      mesh.Points.emplace_back(corner[0], corner[1], z);
    }
  }
  // The top, seen from above, as a fan around the inner corner; the bottom in reverse order.
  for (const auto& t : {std::array<int, 3>{3, 4, 5}, std::array<int, 3>{3, 5, 0},
                        std::array<int, 3>{3, 0, 1}, std::array<int, 3>{3, 1, 2}})
  {
    mesh.Triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
    mesh.Triangles.push_back({t[0], t[2], t[1]});
  }
  for (int i = 0; i < 6; ++i)
  {
    const int j = (i + 1) % 6;
    mesh.Triangles.push_back({i, j, j + 6});
    mesh.Triangles.push_back({i, j + 6, i + 6});
  }
  return mesh;
}

TEST(StarShape, SphereIsStarShapedFromInside)
{
  const IndexedMesh sphere = test::Sphere(16, 10.0, {1, 2, 3});
  for (const Vector3& center : {Vector3(1, 2, 3), Vector3(8, 2, 3), Vector3(1, 2, -6)})
  {
    const palpate::StarShapeVerdict verdict = palpate::JudgeStarShape(sphere, center);
    EXPECT_TRUE(verdict.IsStarShaped);
    EXPECT_DOUBLE_EQ(verdict.HiddenPercent, 0.0);
  }
}

TEST(StarShape, SphereHidesFarSideFromOutside)
{
  const IndexedMesh sphere = test::Sphere(30, 10.0, {0, 0, 0});
  // Seen from 20 mm, faces that face the centre count as hidden (they face away from inside): the
  // near cap, (1 - 10 / 20) / 2 of the area; the rest all lies behind that cap.
  const palpate::StarShapeVerdict verdict = palpate::JudgeStarShape(sphere, Vector3(20, 0, 0));
  EXPECT_FALSE(verdict.IsStarShaped);
  EXPECT_NEAR(verdict.HiddenPercent, 100.0, 0.5); // triangles on the rim
}

TEST(StarShape, LShapeIsVisibleOnlyFromItsCorner)
{
  const IndexedMesh shape = LShape();
  EXPECT_TRUE(palpate::JudgeStarShape(shape, Vector3(5, 5, 5)).IsStarShaped);
  // From the end of one arm, the other arm's inner wall (one of 28 squares) faces away.
  const palpate::StarShapeVerdict verdict = palpate::JudgeStarShape(shape, Vector3(25, 5, 5));
  EXPECT_FALSE(verdict.IsStarShaped);
  EXPECT_GT(verdict.HiddenPercent, 10.0);
}

TEST(StarShape, MostVisibleCentreOfLShapeIsItsCorner)
{
  const IndexedMesh shape = LShape();
  const Vector3 centroid = palpate::VolumeCentroid(shape);
  EXPECT_NEAR(centroid.x(), 11.0, 1e-12); // (5 * 10 + 20 * 20 + 5 * 20) / 50
  EXPECT_FALSE(palpate::JudgeStarShape(shape, centroid).IsStarShaped);
  const Vector3 center = palpate::MostVisibleCenter(shape);
  EXPECT_TRUE(palpate::JudgeStarShape(shape, center).IsStarShaped) << center.transpose();
}

TEST(StarShape, CentroidOfSphereIsItsCentre)
{
  const IndexedMesh sphere = test::Sphere(10, 10.0, {100, -50, 7});
  EXPECT_LT((palpate::VolumeCentroid(sphere) - Vector3(100, -50, 7)).norm(), 1e-10);
}
} // namespace
} // namespace palpate::star_shape_test
