#include "SurfaceNormals.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataNormals.h"

namespace palpate
{
vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* surface)
{
  if (surface->GetPointData()->GetNormals())
  {
    return surface;
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}
} // namespace palpate
