#include "MaskOverlap.h"

#include "IsoSurface.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkImageStencilData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataToImageStencil.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
// The surface in continuous image indices: the stencil filter ignores the direction matrix.
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

// The image's extent, extended to the surface, but on no side by more than the image's own size:
// the stencil stores the surface's voxels as a list of rows, and its bounds may be arbitrary
// numbers.
std::array<int, 6> ExtentOf(vtkImageData* image, vtkPolyData* indexSurface)
{
  std::array<int, 6> extent{};
  image->GetExtent(extent.data());
  double bounds[6];
  indexSurface->GetBounds(bounds);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double first = extent[2 * axis];
    const double last = extent[2 * axis + 1];
    const double most = last - first + 1.0;
    extent[2 * axis] =
        static_cast<int>(std::clamp(std::floor(bounds[2 * axis]), first - most, first));
    extent[2 * axis + 1] =
        static_cast<int>(std::clamp(std::ceil(bounds[2 * axis + 1]), last, last + most));
  }
  return extent;
}

bool IsWithin(vtkPolyData* indexSurface, const std::array<int, 6>& extent)
{
  double bounds[6];
  indexSurface->GetBounds(bounds);
  return bounds[0] >= extent[0] && bounds[1] <= extent[1] && bounds[2] >= extent[2] &&
         bounds[3] <= extent[3] && bounds[4] >= extent[4] && bounds[5] <= extent[5];
}

// Number of voxels that a closed surface encloses, from its volume in index space.
long long EnclosedVoxels(vtkPolyData* indexSurface)
{
  const double volume = std::abs(MeasureEnclosed(indexSurface).Volume);
  constexpr double Most = 1e18;
  return std::llround(volume < Most ? volume : Most); // also if it is not a number
}

bool IsFinite(vtkPolyData* indexSurface)
{
  const auto* points =
      vtkDoubleArray::SafeDownCast(indexSurface->GetPoints()->GetData())->GetPointer(0);
  return std::all_of(points, points + 3 * indexSurface->GetNumberOfPoints(),
                     [](double coordinate) { return std::isfinite(coordinate); });
}

template <typename T>
VoxelCounts CountVoxels(const T* voxels, const int image[6], const std::array<int, 6>& extent,
                        vtkImageStencilData* stencil, int label)
{
  const T wanted = static_cast<T>(label);
  const std::ptrdiff_t width = image[1] - image[0] + 1;
  const std::ptrdiff_t height = image[3] - image[2] + 1;
  VoxelCounts counts;
  counts.Mask = std::count(voxels, voxels + width * height * (image[5] - image[4] + 1), wanted);
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      const bool isInside = j >= image[2] && j <= image[3] && k >= image[4] && k <= image[5];
      const T* row =
          isInside ? voxels + ((k - image[4]) * height + (j - image[2])) * width : voxels;
      int first = 0;
      int last = 0;
      int iterator = 0;
      while (stencil->GetNextExtent(first, last, extent[0], extent[1], j, k, iterator) != 0)
      {
        counts.Surface += last - first + 1;
        for (int i = std::max(first, image[0]); isInside && i <= std::min(last, image[1]); ++i)
        {
          counts.Both += row[i - image[0]] == wanted ? 1 : 0;
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
  if (!IsFinite(indexSurface))
  {
    return 0.0;
  }
  int imageExtent[6];
  mask->GetExtent(imageExtent);
  std::array<int, 6> extent = ExtentOf(mask, indexSurface);
  vtkNew<vtkPolyDataToImageStencil> voxelize;
  voxelize->SetInputData(indexSurface);
  voxelize->SetOutputWholeExtent(extent.data());
  voxelize->SetOutputSpacing(1.0, 1.0, 1.0);
  voxelize->SetOutputOrigin(0.0, 0.0, 0.0);
  voxelize->Update();
  vtkDataArray* scalars = mask->GetPointData()->GetScalars();
  VoxelCounts counts;
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(counts = CountVoxels(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)),
                                          imageExtent, extent, voxelize->GetOutput(), label));
  default:
    break;
  }
  if (!IsWithin(indexSurface, extent))
  {
    counts.Surface = std::max(counts.Surface, EnclosedVoxels(indexSurface));
  }
  const long long sum = counts.Mask + counts.Surface;
  return sum > 0 ? 2.0 * static_cast<double>(counts.Both) / static_cast<double>(sum) : 0.0;
}
} // namespace palpate
