#include "LocalThickness.h"

#include "ComparedCases.h"
#include "MeshShapes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::local_thickness_test
{
namespace
{
IndexedMesh Ellipsoid(int frequency, const Vector3& axes)
{
  IndexedMesh mesh = test::Sphere(frequency);
  for (Vector3& point : mesh.Points)
  {
    point = point.cwiseProduct(axes);
  }
  return mesh;
}

// Of an ellipsoid at a point of it, by its definition over points as dense as a grid of a degree.
double EllipsoidThickness(const Vector3& axes, const Vector3& point)
{
  const Vector3 inward = -point.cwiseQuotient(axes.cwiseProduct(axes)).normalized();
  double radius = std::numeric_limits<double>::infinity();
  for (int i = 1; i < 180; ++i)
  {
    for (int j = 0; j < 360; ++j)
    {
      const double polar = M_PI / 180.0 * i;
      const double around = M_PI / 180.0 * j;
      const Vector3 there(axes[0] * std::sin(polar) * std::cos(around),
                          axes[1] * std::sin(polar) * std::sin(around), axes[2] * std::cos(polar));
      const double depth = (there - point).dot(inward);
      if (depth > 1e-6 * axes[0])
      {
        radius = std::min(radius, (there - point).squaredNorm() / (2.0 * depth));
      }
    }
  }
  return 2.0 * radius;
}

TEST(LocalThickness, OfABallIsItsDiameter)
{
  for (const double thickness :
       LocalThicknessOf(test::BodyOfModel(test::SphereModel(8.0)).Surface(), {}))
  {
    ASSERT_NEAR(thickness, 16.0, 0.03); // from normals of triangles
  }
}

TEST(LocalThickness, OfAShellIsItsWallOnBothSides)
{
  const IndexedMesh shell =
      test::Join(test::Sphere(60, 12.0), test::Reversed(test::Sphere(60, 10.5)));
  for (const double thickness : LocalThicknessOf(shell, {}))
  {
    EXPECT_NEAR(thickness, 1.5, 0.01); // triangles of 0.2 mm
  }
}

TEST(LocalThickness, OfAnEllipsoidIsThatOfItsDefinition)
{
  const Vector3 axes(15.0, 9.0, 6.0);
  const IndexedMesh mesh = Ellipsoid(60, axes);
  const std::vector<double> thickness = LocalThicknessOf(mesh, {});
  double worst = 0.0;
  for (std::size_t i = 0; i < thickness.size(); i += 97)
  {
    const double error = std::abs(thickness[i] - EllipsoidThickness(axes, mesh.Points[i]));
    worst = std::max(worst, error);
  }
  EXPECT_LT(worst, 0.1);
}

constexpr double Half = 0.35; // half of the angle between a wedge's faces
constexpr double Length = 20.0;

// Of which y is the edge.
ComparedBody Wedge()
{
  const double height = Length * std::tan(Half);
  const IndexedMesh wedge{{{0.0, 0.0, 0.0},
                           {0.0, 40.0, 0.0},
                           {Length, 0.0, height},
                           {Length, 40.0, height},
                           {Length, 0.0, -height},
                           {Length, 40.0, -height}},
                          {{{0, 2, 3}},
                           {{0, 3, 1}},
                           {{0, 1, 5}},
                           {{0, 5, 4}},
                           {{2, 4, 5}},
                           {{2, 5, 3}},
                           {{0, 4, 2}},
                           {{1, 3, 5}}}};
  return test::BodyOfMesh(wedge);
}

TEST(LocalThickness, OfAWedgeGrowsFromItsEdge)
{
  const ComparedBody body = Wedge();
  const std::vector<double> thickness = LocalThicknessOf(body.Surface(), {});
  int seen = 0;
  for (std::size_t i = 0; i < thickness.size(); ++i)
  {
    const Vector3& point = body.Surface().Points[i];
    const double along = std::hypot(point.x(), point.z());
    const double radius = along * std::tan(Half);
    const bool isOnFace = std::abs(std::abs(point.z()) - point.x() * std::tan(Half)) < 1e-9;
    const bool isFree = along > 1.0 && point.y() > radius + 1.0 && point.y() < 39.0 - radius &&
                        along / std::cos(Half) + radius < Length;
    if (isOnFace && isFree)
    {
      EXPECT_NEAR(thickness[i], 2.0 * radius, 0.05) << point.transpose();
      ++seen;
    }
  }
  EXPECT_GT(seen, 100);
}

ThicknessSettings Rays()
{
  ThicknessSettings settings;
  settings.Rule = ThicknessRule::Rays;
  return settings;
}

TEST(RayThickness, OfABallIsItsDiameter)
{
  for (const double thickness :
       LocalThicknessOf(test::BodyOfModel(test::SphereModel(8.0)).Surface(), Rays()))
  {
    ASSERT_NEAR(thickness, 16.0, 0.03);
  }
}

TEST(RayThickness, OfAShellIsItsWallOnBothSides)
{
  const IndexedMesh shell =
      test::Join(test::Sphere(60, 12.0), test::Reversed(test::Sphere(60, 10.5)));
  for (const double thickness : LocalThicknessOf(shell, Rays()))
  {
    EXPECT_NEAR(thickness, 1.5, 0.01);
  }
}

// The line p + t n meets x^T A x = 1 again at t = -2 p^T A n / n^T A n.
TEST(RayThickness, OfAnEllipsoidIsItsChordAlongTheNormal)
{
  const Vector3 axes(15.0, 9.0, 6.0);
  const IndexedMesh mesh = Ellipsoid(60, axes);
  const Vector3 form = axes.cwiseProduct(axes).cwiseInverse();
  const std::vector<double> thickness = LocalThicknessOf(mesh, Rays());
  for (std::size_t i = 0; i < thickness.size(); ++i)
  {
    const Vector3& point = mesh.Points[i];
    const Vector3 inward = -point.cwiseProduct(form).normalized();
    const double chord =
        -2.0 * point.cwiseProduct(form).dot(inward) / inward.cwiseProduct(form).dot(inward);
    ASSERT_NEAR(thickness[i], chord, 0.05) << point.transpose();
  }
}

TEST(RayThickness, OfAWedgeIsTheTangentOfItsAngle)
{
  const ComparedBody body = Wedge();
  const std::vector<double> thickness = LocalThicknessOf(body.Surface(), Rays());
  int seen = 0;
  for (std::size_t i = 0; i < thickness.size(); ++i)
  {
    const Vector3& point = body.Surface().Points[i];
    const double along = std::hypot(point.x(), point.z());
    const bool isOnFace = std::abs(std::abs(point.z()) - point.x() * std::tan(Half)) < 1e-9;
    // Away from edges, and where the ray ends on the other face.
    const bool isFree = along > 1.0 && point.y() > 1.0 && point.y() < 39.0 &&
                        along / std::cos(2.0 * Half) < Length / std::cos(Half) - 0.5;
    if (isOnFace && isFree)
    {
      EXPECT_NEAR(thickness[i], along * std::tan(2.0 * Half), 1e-6) << point.transpose();
      ++seen;
    }
  }
  EXPECT_GT(seen, 100);
}

// A ball with the diameter 2 r has a chord of 2 r along the normal.
TEST(RayThickness, IsAtLeastThatOfSpheres)
{
  const IndexedMesh mesh = test::Lobed(40);
  const std::vector<double> spheres = LocalThicknessOf(mesh, {});
  const std::vector<double> rays = LocalThicknessOf(mesh, Rays());
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    ASSERT_GE(rays[i], spheres[i] - 0.05);
  }
}

// A cap of a ball: its cut, which is not there, limits neither.
TEST(LocalThickness, IgnoresWhatIsLeftOut)
{
  IndexedMesh mesh = test::Sphere(40, 8.0);
  const auto isLow = [&](const std::array<int, 3>& t) {
    return std::min({mesh.Points[t[0]].z(), mesh.Points[t[1]].z(), mesh.Points[t[2]].z()}) < 2.0;
  };
  mesh.Triangles.erase(std::remove_if(mesh.Triangles.begin(), mesh.Triangles.end(), isLow),
                       mesh.Triangles.end());
  const std::vector<double> spheres = LocalThicknessOf(mesh, {});
  const std::vector<double> rays = LocalThicknessOf(mesh, Rays());
  for (std::size_t i = 0; i < spheres.size(); ++i)
  {
    const bool isThere = mesh.Points[i].z() > 2.3;
    if (isThere)
    {
      EXPECT_NEAR(spheres[i], 6.0, 0.3); // the least extent
    }
    EXPECT_TRUE(isThere || mesh.Points[i].z() > 1.9 || std::isnan(spheres[i]));
    EXPECT_TRUE(std::isnan(rays[i]));
  }
}

// Masks have noise, which balls see as curvature: the middle of the errors is as good.
TEST(LocalThickness, OfMasksIsRightInTheMedian)
{
  IndexToWorld toWorld;
  toWorld.Origin = Vector3::Constant(-20.3);
  const Vector3 axes(15.0, 9.0, 6.0);
  const auto isIn = [&](const Vector3& world) { return world.cwiseQuotient(axes).norm() < 1.0; };
  const ComparedBody steps = test::BodyOfVoxels({41, 41, 41}, toWorld, isIn);
  ComparedBody body;
  ASSERT_TRUE(ComparedBody::OfMaskShape(steps.Mask()->Voxels, toWorld, body).IsOk());
  const std::vector<Vector3>& points = body.Surface().Points;
  const std::vector<double> thickness =
      LocalThicknessOf(body.Surface(), ThicknessSettings::OfVoxels(toWorld.Axes));
  std::vector<double> errors;
  for (std::size_t i = 0; i < points.size(); i += 11)
  {
    const Vector3 on = points[i] / points[i].cwiseQuotient(axes).norm();
    errors.push_back(thickness[i] - EllipsoidThickness(axes, on));
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_NEAR(errors[errors.size() / 2], 0.0, 0.25);
  EXPECT_GT(errors[errors.size() / 20], -1.5);
  EXPECT_LT(errors[errors.size() - 1 - errors.size() / 20], 2.0);
}

TEST(LocalThickness, OfAMaskOfABowlIsItsWall)
{
  IndexToWorld toWorld;
  toWorld.Origin = Vector3::Constant(-20.3);
  const auto isIn = [](const Vector3& world)
  { return world.norm() < 17.0 && world.norm() > 12.5 && world.z() < 3.0; };
  const ComparedBody steps = test::BodyOfVoxels({41, 41, 41}, toWorld, isIn);
  ComparedBody body;
  ASSERT_TRUE(ComparedBody::OfMaskShape(steps.Mask()->Voxels, toWorld, body).IsOk());
  const std::vector<double> thickness =
      LocalThicknessOf(body.Surface(), ThicknessSettings::OfVoxels(toWorld.Axes));
  std::vector<double> walls; // away from the rim
  for (std::size_t i = 0; i < thickness.size(); ++i)
  {
    if (body.Surface().Points[i].z() < -1.0)
    {
      walls.push_back(thickness[i]);
    }
  }
  std::sort(walls.begin(), walls.end());
  EXPECT_NEAR(walls[walls.size() / 2], 4.5, 0.15);
}
} // namespace
} // namespace palpate::local_thickness_test
