#include "SceneIsoSurface.h"

#include "FieldOfImage.h"
#include "FilterRun.h"
#include "Refusal.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace palpate
{
namespace
{
// Of an image whose axes are the frame's: VTK's contour filters lose its direction.
void MoveToWorld(const FieldGrid& grid, vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkIdType count = surface->GetNumberOfPoints();
  points->SetNumberOfPoints(count);
  for (vtkIdType id = 0; id < count; ++id)
  {
    Vector3 point;
    surface->GetPoint(id, point.data());
    points->SetPoint(id, Vector3(grid.OriginWorld() + grid.Direction() * point).data());
  }
  surface->SetPoints(points);
}
} // namespace

vtkSmartPointer<vtkPolyData> MakeIsoSurface(vtkImageData* image, double isoValue,
                                            const ProgressFunction& progress)
{
  const FieldGrid grid = GridOfImage(image);
  vtkNew<vtkImageData> plain;
  plain->SetDimensions(grid.Size().data());
  plain->SetSpacing(grid.Spacing().data());
  plain->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(plain);
  contour->SetValue(0, isoValue);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  RunFilter(contour, "surface", 0.0, 1.0, progress);
  vtkSmartPointer<vtkPolyData> surface = contour->GetOutput();
  if (surface->GetNumberOfCells() == 0)
  {
    double range[2] = {};
    plain->GetScalarRange(range);
    throw FilterError("The iso-value " + NumberText(isoValue) +
                      " gives no surface: the image's values run from " + NumberText(range[0]) +
                      " to " + NumberText(range[1]) + ".");
  }
  MoveToWorld(grid, surface);
  return surface;
}
} // namespace palpate
