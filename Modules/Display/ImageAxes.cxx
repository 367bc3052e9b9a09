#include "ImageAxes.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <Eigen/LU>

namespace palpate
{
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
} // namespace palpate
