#include "ReducedImage.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
namespace
{
using Size = std::array<int, 3>;

double Voxels(const Size& size)
{
  return 1.0 * size[0] * size[1] * size[2];
}

Size BlocksOf(const Size& size, int side)
{
  Size blocks{};
  std::transform(size.begin(), size.end(), blocks.begin(),
                 [side](int count) { return std::max(1, count / side); });
  return blocks;
}

// Sums of rows of blocks: reads the image once, in the order of its memory.
void AddRow(vtkDataArray* values, vtkIdType first, int side, int blocks, int last, double* sums)
{
  const int used = std::min(last, blocks * side);
  for (int i = 0; i < used; ++i)
  {
    sums[std::min(i / side, blocks - 1)] += values->GetComponent(first + i, 0);
  }
}

vtkSmartPointer<vtkFloatArray> Averages(vtkDataArray* values, const Size& size, const Size& blocks,
                                        int side)
{
  auto made = vtkSmartPointer<vtkFloatArray>::New();
  made->SetNumberOfTuples(static_cast<vtkIdType>(Voxels(blocks)));
  std::vector<double> sums(static_cast<std::size_t>(blocks[0]));
  vtkIdType next = 0;
  const std::array<int, 3> sides{std::min(side, size[0]), std::min(side, size[1]),
                                 std::min(side, size[2])};
  const double perBlock = 1.0 / Voxels(sides);
  for (int k = 0; k < blocks[2]; ++k)
  {
    for (int j = 0; j < blocks[1]; ++j)
    {
      std::fill(sums.begin(), sums.end(), 0.0);
      for (int row = 0; row < sides[1] * sides[2]; ++row)
      {
        const vtkIdType y = j * side + row % sides[1];
        const vtkIdType z = k * side + row / sides[1];
        AddRow(values, (z * size[1] + y) * size[0], side, blocks[0], size[0], sums.data());
      }
      for (const double sum : sums)
      {
        made->SetValue(next++, static_cast<float>(perBlock * sum));
      }
    }
  }
  return made;
}
} // namespace

vtkSmartPointer<vtkImageData> ReducedImage(vtkImageData* image, double mostVoxels)
{
  auto made = vtkSmartPointer<vtkImageData>::New();
  vtkDataArray* values = image->GetPointData()->GetScalars();
  Size size{};
  image->GetDimensions(size.data());
  int side = 1;
  while (Voxels(BlocksOf(size, side)) > mostVoxels)
  {
    ++side;
  }
  if (side == 1 && values->GetNumberOfComponents() == 1)
  {
    made->ShallowCopy(image);
    return made;
  }
  const Size blocks = BlocksOf(size, side);
  // The first block's centre.
  const double middle = 0.5 * (side - 1);
  const int* extent = image->GetExtent();
  double origin[3];
  image->TransformContinuousIndexToPhysicalPoint(
      extent[0] + std::min(middle, size[0] - 1.0), extent[2] + std::min(middle, size[1] - 1.0),
      extent[4] + std::min(middle, size[2] - 1.0), origin);
  const double* spacing = image->GetSpacing();
  made->SetDimensions(blocks.data());
  made->SetOrigin(origin);
  made->SetSpacing(side * spacing[0], side * spacing[1], side * spacing[2]);
  made->SetDirectionMatrix(image->GetDirectionMatrix());
  made->GetPointData()->SetScalars(Averages(values, size, blocks, side));
  return made;
}
} // namespace palpate
