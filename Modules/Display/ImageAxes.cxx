#include "ImageAxes.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
template <typename T>
void GrowBox(const T* voxels, const ImageAxes& axes, int value, IndexBox& box)
{
  const int rowLength = axes.Size(0);
  for (int k = axes.Extent[4]; k <= axes.Extent[5]; ++k)
  {
    for (int j = axes.Extent[2]; j <= axes.Extent[3]; ++j, voxels += rowLength)
    {
      const auto isValue = [value](T v) { return static_cast<double>(v) == value; };
      const T* first = std::find_if(voxels, voxels + rowLength, isValue);
      if (first == voxels + rowLength)
      {
        continue;
      }
      const T* last = voxels + rowLength - 1;
      while (!isValue(*last))
      {
        --last;
      }
      const int lowI = axes.Extent[0] + static_cast<int>(first - voxels);
      const int highI = axes.Extent[0] + static_cast<int>(last - voxels);
      box.Low = box.Low.cwiseMin(Eigen::Vector3i(lowI, j, k));
      box.High = box.High.cwiseMax(Eigen::Vector3i(highI, j, k));
    }
  }
}
} // namespace

ImageAxes::ImageAxes(vtkImageData* image)
{
  image->GetExtent(this->Extent.data());
  image->GetSpacing(this->Spacing.data());
  this->OriginWorld = Vector3(image->GetOrigin());
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int row = 0; row < 3; ++row)
    {
      this->UnitWorld[axis][row] = image->GetDirectionMatrix()->GetElement(row, axis);
    }
    this->StepWorld.col(axis) = this->Spacing[axis] * this->UnitWorld[axis];
  }
  this->WorldToIndex = this->StepWorld.inverse();
}

std::array<Vector3, 8> ImageAxes::CornersWorld() const
{
  std::array<Vector3, 8> corners;
  for (std::size_t c = 0; c < 8; ++c)
  {
    Vector3 index;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const bool isUpper = (c >> axis & 1U) != 0;
      index[static_cast<int>(axis)] =
          isUpper ? this->Extent[2 * axis + 1] + 0.5 : this->Extent[2 * axis] - 0.5;
    }
    corners[c] = this->ToWorld(index);
  }
  return corners;
}

vtkSmartPointer<vtkPolyData> MakeBox(const std::array<Vector3, 8>& corners)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& corner : corners)
  {
    points->InsertNextPoint(corner.data());
  }
  vtkNew<vtkCellArray> faces;
  for (const auto& face : {std::array<vtkIdType, 4>{{0, 1, 3, 2}},
                           {{4, 6, 7, 5}},
                           {{0, 4, 5, 1}},
                           {{2, 3, 7, 6}},
                           {{0, 2, 6, 4}},
                           {{1, 5, 7, 3}}})
  {
    faces->InsertNextCell(4, face.data());
  }
  auto box = vtkSmartPointer<vtkPolyData>::New();
  box->SetPoints(points);
  box->SetPolys(faces);
  return box;
}

bool FindValueBox(vtkImageData* image, int value, IndexBox& box)
{
  const ImageAxes axes(image);
  box.Low.setConstant(std::numeric_limits<int>::max());
  box.High.setConstant(std::numeric_limits<int>::lowest());
  switch (image->GetScalarType())
  {
    vtkTemplateMacro(
        GrowBox(static_cast<const VTK_TT*>(image->GetScalarPointer()), axes, value, box));
  }
  return box.Low.x() <= box.High.x();
}
} // namespace palpate
