#include "SurfaceCut.h"

#include "ModelMesh.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::surface_cut_test
{
namespace
{
double Length(const SurfaceCurve& curve)
{
  double length = 0.0;
  for (std::size_t p = 1; p < curve.Points.size(); ++p)
  {
    length += (curve.Points[p] - curve.Points[p - 1]).norm();
  }
  return length + (curve.IsClosed ? (curve.Points.front() - curve.Points.back()).norm() : 0.0);
}

TEST(SurfaceCut, SphereIsCutInOneCircle)
{
  std::mt19937_64 random(77);
  std::normal_distribution<double> gauss;
  const Vector3 center(12.0, -80.0, 33.0);
  const auto mesh = palpate::test::MakeModelMesh(palpate::test::SphereModel(10.0, center), 40);
  for (int trial = 0; trial < 50; ++trial)
  {
    const Vector3 normal = Vector3(gauss(random), gauss(random), gauss(random)).normalized();
    const double height = std::uniform_real_distribution<double>(-9.0, 9.0)(random);
    const auto curves = CutSurface(mesh, center + height * normal, normal);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_TRUE(curves.front().IsClosed);
    const double radius = std::sqrt(100.0 - height * height);
    for (const Vector3& point : curves.front().Points)
    {
      // Linear interpolation along an edge leaves rounding only.
      ASSERT_NEAR(normal.dot(point - center), height, 1e-10);
    }
    // Triangles of 0.3 mm lie within 0.002 mm of the sphere; near a pole the circle is small.
    EXPECT_NEAR(Length(curves.front()), 2.0 * M_PI * radius, 0.01 * radius);
  }
}

TEST(SurfaceCut, CutThroughMeshPointsGivesOneCurve)
{
  // The icosahedron's mesh has points in the coordinate planes.
  const auto mesh =
      palpate::test::MakeModelMesh(palpate::test::SphereModel(10.0, Vector3::Zero()), 8);
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto curves = CutSurface(mesh, Vector3::Zero(), Vector3::Unit(axis));
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_TRUE(curves.front().IsClosed);
  }
}

TEST(SurfaceCut, OpenSurfaceIsCutInOpenCurve)
{
  vtkNew<vtkPoints> points;
  for (const Vector3& p : {Vector3(0, 0, 0), Vector3(3, 0, 0), Vector3(0, 3, 0), Vector3(3, 3, 0)})
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({0, 1, 2});
  triangles->InsertNextCell({1, 3, 2});
  vtkNew<vtkPolyData> square;
  square->SetPoints(points);
  square->SetPolys(triangles);
  const auto curves = CutSurface(square, Vector3(0, 1, 0), Vector3::UnitY());
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves.front().IsClosed);
  EXPECT_NEAR(Length(curves.front()), 3.0, 1e-12);
}

TEST(SurfaceCut, MissingPlaneGivesNoCurve)
{
  const auto mesh =
      palpate::test::MakeModelMesh(palpate::test::SphereModel(10.0, Vector3::Zero()), 4);
  EXPECT_TRUE(CutSurface(mesh, Vector3(0, 0, 10.5), Vector3::UnitZ()).empty());
  vtkNew<vtkPolyData> nothing;
  EXPECT_TRUE(CutSurface(nothing, Vector3::Zero(), Vector3::UnitZ()).empty());
}
} // namespace
} // namespace palpate::surface_cut_test
