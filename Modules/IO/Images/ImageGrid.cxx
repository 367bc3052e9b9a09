#include "ImageGrid.h"

#include "DecimalText.h"
#include "PositiveNumber.h"
#include "Refusal.h"
#include "SingularValues.h"

#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <Eigen/LU>
#include <cmath>
#include <string>

namespace palpate
{
namespace
{
void CheckSize(const std::filesystem::path& file, const ImageGrid& grid)
{
  const std::string size = std::to_string(grid.Size[0]) + " x " + std::to_string(grid.Size[1]) +
                           " x " + std::to_string(grid.Size[2]);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (grid.Size[static_cast<std::size_t>(axis)] < 2)
    {
      Refuse(file, "is two-dimensional (" + size + " voxels)",
             "use a volume of at least two slices");
    }
  }
  // Below this, counts of voxels and bytes are exact in double.
  constexpr double MostVoxels = 1e15;
  if (!(static_cast<double>(grid.Size[0]) * grid.Size[1] * grid.Size[2] <= MostVoxels))
  {
    Refuse(file, "has a damaged header (" + size + " voxels)", "copy or export it again");
  }
}

void CheckSpacing(const std::filesystem::path& file, const ImageGrid& grid)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = grid.Spacing[axis];
    if (!IsPositive(spacing))
    {
      Refuse(file,
             "has a voxel spacing of " + SignificantText(spacing) + " mm along axis " +
                 std::to_string(axis + 1),
             "correct its header: spacings must be positive");
    }
  }
}
} // namespace

void CheckGrid(const std::filesystem::path& file, ImageGrid& grid)
{
  CheckSize(file, grid);
  CheckSpacing(file, grid);
  if (!grid.OriginWorld.allFinite() || !grid.Direction.allFinite())
  {
    Refuse(file, "has an origin or direction that is not finite", "correct its header");
  }
  const Eigen::Matrix3d gram = grid.Direction.transpose() * grid.Direction;
  const double deviation = (gram - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(deviation <= 1e-4))
  {
    Refuse(file,
           "has axes that are not perpendicular unit vectors (off by " +
               SignificantText(deviation) + ": a sheared direction)",
           "resample it to a rectangular grid");
  }
  if (deviation > 1e-15)
  {
    grid.Direction = SingularValuesOf(grid.Direction).NearestOrthogonal();
  }
}

vtkSmartPointer<vtkImageData> MakeImage(const ImageGrid& grid, vtkDataArray* voxels)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(grid.Size.data());
  image->SetSpacing(grid.Spacing.data());
  image->SetOrigin(grid.OriginWorld.data());
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = grid.Direction;
  image->SetDirectionMatrix(rows.data());
  image->GetPointData()->SetScalars(voxels);
  return image;
}

ImageGrid GridOf(vtkImageData* image)
{
  ImageGrid grid;
  image->GetDimensions(grid.Size.data());
  image->GetSpacing(grid.Spacing.data());
  image->GetOrigin(grid.OriginWorld.data());
  grid.Direction = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
      image->GetDirectionMatrix()->GetData());
  return grid;
}
} // namespace palpate
