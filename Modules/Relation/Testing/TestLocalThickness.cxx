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

TEST(LocalThickness, OfAWedgeGrowsFromItsEdge)
{
  constexpr double Half = 0.35; // half of the angle between the faces
  constexpr double Length = 20.0;
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
  const ComparedBody body = test::BodyOfMesh(wedge);
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
