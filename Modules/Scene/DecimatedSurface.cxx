#include "DecimatedSurface.h"

#include "FilterRun.h"

#include "vtkNew.h"
#include "vtkQuadricDecimation.h"

namespace palpate
{
vtkSmartPointer<vtkPolyData> DecimatedSurface(vtkPolyData* surface, int facets,
                                              const ProgressFunction& progress)
{
  auto shared = vtkSmartPointer<vtkPolyData>::New();
  shared->ShallowCopy(surface);
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(shared);
  decimation->VolumePreservationOn();
  decimation->SetTargetReduction(1.0 - facets / static_cast<double>(surface->GetNumberOfCells()));
  RunFilter(decimation, "fewer facets", 0.0, 1.0, progress);
  return decimation->GetOutput();
}
} // namespace palpate
