#include "MaskOverlap.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageStencilData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataToImageStencil.h"

namespace palpate
{
namespace
{
// The surface in continuous image indices: the stencil filter knows no direction.
void CopyToIndexSpace(vtkPolyData* surface, vtkImageData* image, vtkPolyData* result)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(surface->GetNumberOfPoints());
  for (vtkIdType id = 0; id < surface->GetNumberOfPoints(); ++id)
  {
    double world[3];
    double index[3];
    surface->GetPoint(id, world);
    image->TransformPhysicalPointToContinuousIndex(world, index);
    points->SetPoint(id, index);
  }
  result->SetPoints(points);
  result->SetPolys(surface->GetPolys());
}

struct VoxelCounts
{
  long long Mask = 0;
  long long Surface = 0;
  long long Both = 0;
};

template <typename T>
VoxelCounts CountVoxels(const T* voxels, const int extent[6], vtkImageStencilData* stencil,
                        int label)
{
  const T wanted = static_cast<T>(label);
  VoxelCounts counts;
  const long long width = extent[1] - extent[0] + 1;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j, voxels += width)
    {
      for (long long i = 0; i < width; ++i)
      {
        counts.Mask += voxels[i] == wanted ? 1 : 0;
      }
      int first = 0;
      int last = 0;
      int iterator = 0;
      while (stencil->GetNextExtent(first, last, extent[0], extent[1], j, k, iterator) != 0)
      {
        counts.Surface += last - first + 1;
        for (int i = first; i <= last; ++i)
        {
          counts.Both += voxels[i - extent[0]] == wanted ? 1 : 0;
        }
      }
    }
  }
  return counts;
}
} // namespace

double DiceOfSurfaceAndMask(vtkPolyData* surface, vtkImageData* mask, int label)
{
  vtkNew<vtkPolyData> indexSurface;
  CopyToIndexSpace(surface, mask, indexSurface);
  int extent[6];
  mask->GetExtent(extent);
  vtkNew<vtkPolyDataToImageStencil> voxelize;
  voxelize->SetInputData(indexSurface);
  voxelize->SetOutputWholeExtent(extent);
  voxelize->SetOutputSpacing(1.0, 1.0, 1.0);
  voxelize->SetOutputOrigin(0.0, 0.0, 0.0);
  voxelize->Update();
  vtkDataArray* scalars = mask->GetPointData()->GetScalars();
  VoxelCounts counts;
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(counts = CountVoxels(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)),
                                          extent, voxelize->GetOutput(), label));
  default:
    break;
  }
  const long long sum = counts.Mask + counts.Surface;
  return sum > 0 ? 2.0 * static_cast<double>(counts.Both) / static_cast<double>(sum) : 0.0;
}
} // namespace palpate
