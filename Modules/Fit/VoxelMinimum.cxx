#include "VoxelMinimum.h"

#include "DecimalText.h"
#include "FitResult.h"
#include "Segmentation.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// A few voxels have no shape: fewer than 2 x 2 x 2.
constexpr long SmallestVoxelCount = 8;

std::string TooFew(long voxels)
{
  return "has only " + CountText(voxels, "voxel", "voxels") + ", too few to have a shape";
}

// Voxels of the label, up to the required number.
template <typename T>
long CountVoxels(const T* values, vtkIdType count, int label)
{
  const T* end = values + count;
  long found = 0;
  for (const T* at = std::find(values, end, static_cast<T>(label));
       at != end && found < SmallestVoxelCount; at = std::find(at + 1, end, static_cast<T>(label)))
  {
    ++found;
  }
  return found;
}
} // namespace

std::string TooFewVoxels(double cubicMillimeters, vtkImageData* mask)
{
  const double* spacing = mask->GetSpacing();
  const long voxels = std::lround(cubicMillimeters / (spacing[0] * spacing[1] * spacing[2]));
  return voxels >= SmallestVoxelCount ? std::string() : TooFew(voxels);
}

std::string TooFewVoxels(const Segmentation& segmentation, const Segment& structure)
{
  vtkDataArray* labels =
      segmentation.Layers[static_cast<std::size_t>(structure.Layer)]->GetPointData()->GetScalars();
  long voxels = 0;
  switch (labels->GetDataType())
  {
    vtkTemplateMacro(voxels = CountVoxels(static_cast<const VTK_TT*>(labels->GetVoidPointer(0)),
                                          labels->GetNumberOfTuples(), structure.Value));
  default:
    break;
  }
  // Callers have their own message for a structure without voxels.
  return voxels == 0 || voxels >= SmallestVoxelCount ? std::string() : TooFew(voxels);
}

double ResolutionOf(const FitResult& result)
{
  constexpr double PartOfSize = 0.01;
  if (result.Mask == nullptr)
  {
    return PartOfSize * result.Surface->GetLength();
  }
  const double* spacing = result.Mask->GetSpacing();
  return *std::max_element(spacing, spacing + 3);
}

int SupportedDegree(double cubicMillimeters, vtkImageData* mask)
{
  constexpr double Highest = 1000.0;
  if (mask == nullptr)
  {
    return static_cast<int>(Highest);
  }
  const double* spacing = mask->GetSpacing();
  const double coarsest = std::max({spacing[0], spacing[1], spacing[2]});
  const double radius = std::cbrt(3.0 * cubicMillimeters / (4.0 * M_PI));
  return static_cast<int>(std::clamp(std::floor(M_PI * radius / coarsest), 1.0, Highest));
}
} // namespace palpate
