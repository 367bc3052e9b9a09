// Distances against VTK's own, as an independent judge.
#include "BodyComparison.h"
#include "ComparedCases.h"

#include "vtkCellArray.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::signed_distances_test
{
namespace
{
using namespace palpate::test;

vtkSmartPointer<vtkPolyData> PolyDataFrom(const IndexedMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& point : mesh.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    triangles->InsertNextCell({t[0], t[1], t[2]});
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

TEST(BodyDistances, FromMasksBoundaryAreVtks)
{
  IndexToWorld grid;
  grid.Origin = {-20.0, -20.0, -15.0};
  grid.Axes = Vector3(1.0, 1.2, 3.0).asDiagonal();
  const ComparedBody mask = BodyOfVoxels(
      {41, 35, 11}, grid,
      [](const Vector3& p) {
        return p.cwiseQuotient(Vector3(14.0, 11.0, 9.0)).norm() + 0.1 * std::sin(0.5 * p.x()) < 1.0;
      });
  const ComparedBody ellipsoid = BodyOfModel(EllipsoidModel({15.0, 10.0, 8.0}));
  std::vector<double> distances;
  const std::vector<Vector3>& points = ellipsoid.Surface().Points;
  ASSERT_TRUE(mask.DistancesOf(points, {}, distances).IsOk());
  vtkNew<vtkImplicitPolyDataDistance> judge;
  judge->SetInput(PolyDataFrom(mask.Surface()));
  double mean = 0.0;
  for (std::size_t i = 0; i < points.size(); i += 7)
  {
    Vector3 point = points[i];
    const double expected = judge->EvaluateFunction(point.data());
    ASSERT_NEAR(std::abs(distances[i]), std::abs(expected), 1e-5) << i;
    // VTK's sign is that of an averaged normal, which is wrong at some of the steps' edges.
    mean += distances[i] * expected > 0.0 || std::abs(expected) < 1e-3 ? 0.0 : 1.0;
  }
  EXPECT_LT(mean, 0.01 * static_cast<double>(points.size()) / 7.0);
}
} // namespace
} // namespace palpate::signed_distances_test
