#include "SurfaceCut.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCutter.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStripper.h"

#include <limits>

namespace palpate
{
namespace
{
// The same triangles, without what VTK keeps about them on demand, which threads would share.
vtkSmartPointer<vtkPolyData> OwnTriangles(vtkPolyData* surface)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  if (surface->GetNumberOfPolys() > 0)
  {
    vtkNew<vtkPoints> points;
    points->ShallowCopy(surface->GetPoints());
    vtkNew<vtkCellArray> triangles;
    triangles->ShallowCopy(surface->GetPolys());
    copy->SetPoints(points);
    copy->SetPolys(triangles);
  }
  return copy;
}
} // namespace

std::vector<SurfaceCurve> CutSurface(vtkPolyData* surface, const Vector3& origin,
                                     const Vector3& normal)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin.data());
  plane->SetNormal(normal.data());
  vtkNew<vtkCutter> cutter;
  const auto triangles = OwnTriangles(surface);
  cutter->SetInputData(triangles);
  cutter->SetCutFunction(plane);
  cutter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkStripper> stripper; // joins segments to curves
  stripper->SetInputConnection(cutter->GetOutputPort());
  stripper->JoinContiguousSegmentsOn();
  stripper->SetMaximumLength(std::numeric_limits<int>::max());
  stripper->Update();

  std::vector<SurfaceCurve> curves;
  vtkPolyData* cut = stripper->GetOutput();
  const auto iterator = vtk::TakeSmartPointer(cut->GetLines()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(count, ids);
    SurfaceCurve curve;
    curve.IsClosed = count > 3 && ids[0] == ids[count - 1];
    for (vtkIdType n = 0; n < count - (curve.IsClosed ? 1 : 0); ++n)
    {
      curve.Points.emplace_back(Vector3(cut->GetPoint(ids[n])));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}
} // namespace palpate
