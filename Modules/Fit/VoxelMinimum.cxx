#include "VoxelMinimum.h"

#include "Segmentation.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace palpate
{
namespace
{
// A few voxels have no shape: fewer than 2 x 2 x 2.
constexpr long SmallestVoxelCount = 8;

std::string TooFew(long voxels)
{
  return "has only " + std::to_string(voxels) + (voxels == 1 ? " voxel" : " voxels") +
         ", too few to have a shape";
}

// Voxels of the label, up to the required number.
template <typename T>
std::vector<vtkIdType> FirstVoxels(vtkDataArray* labels, int label)
{
  const T* values = static_cast<const T*>(labels->GetVoidPointer(0));
  const T* end = values + labels->GetNumberOfTuples();
  std::vector<vtkIdType> found;
  for (const T* at = std::find(values, end, static_cast<T>(label));
       at != end && found.size() < SmallestVoxelCount;
       at = std::find(at + 1, end, static_cast<T>(label)))
  {
    found.push_back(at - values);
  }
  return found;
}

std::vector<vtkIdType> FirstVoxels(vtkDataArray* labels, int label)
{
  switch (labels->GetDataType())
  {
  case VTK_UNSIGNED_CHAR:
    return FirstVoxels<unsigned char>(labels, label);
  case VTK_UNSIGNED_SHORT:
    return FirstVoxels<unsigned short>(labels, label);
  default:
    return FirstVoxels<int>(labels, label);
  }
}

bool ShareAFace(vtkImageData* image, vtkIdType one, vtkIdType other)
{
  const int* size = image->GetDimensions();
  const auto place = [&](vtkIdType voxel)
  {
    return std::array<vtkIdType, 3>{voxel % size[0], voxel / size[0] % size[1],
                                    voxel / size[0] / size[1]};
  };
  const auto a = place(one);
  const auto b = place(other);
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) == 1;
}

// Size of the largest part connected through faces.
std::size_t LargestPart(vtkImageData* image, std::vector<vtkIdType> voxels)
{
  std::size_t largest = 0;
  while (!voxels.empty())
  {
    std::vector<vtkIdType> part{voxels.back()};
    voxels.pop_back();
    for (std::size_t p = 0; p < part.size(); ++p)
    {
      const auto joined =
          std::partition(voxels.begin(), voxels.end(),
                         [&](vtkIdType voxel) { return !ShareAFace(image, part[p], voxel); });
      part.insert(part.end(), joined, voxels.end());
      voxels.erase(joined, voxels.end());
    }
    largest = std::max(largest, part.size());
  }
  return largest;
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
  vtkImageData* layer = segmentation.Layers[static_cast<std::size_t>(structure.Layer)];
  const std::vector<vtkIdType> voxels =
      FirstVoxels(layer->GetPointData()->GetScalars(), structure.Value);
  // Callers have their own message for a structure without voxels.
  return voxels.empty() || voxels.size() >= SmallestVoxelCount
             ? std::string()
             : TooFew(static_cast<long>(LargestPart(layer, voxels)));
}
} // namespace palpate
