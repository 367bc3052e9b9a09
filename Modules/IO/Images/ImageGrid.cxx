#include "ImageGrid.h"

#include "DecimalText.h"
#include "PositiveNumber.h"
#include "Refusal.h"
#include "SingularValues.h"

#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <Eigen/LU>
#include <algorithm>
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
  // Far beyond every scanner and microscope. Numbers of voxels and of triangles that are computed
  // from sizes in mm stay within their types.
  constexpr double Smallest = 1e-6; // mm
  constexpr double Largest = 1e6;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = grid.Spacing[axis];
    const bool isPositive = IsPositive(spacing);
    if (!isPositive || spacing < Smallest || spacing > Largest)
    {
      Refuse(file,
             "has a voxel spacing of " + SignificantText(spacing) + " mm along axis " +
                 std::to_string(axis + 1),
             isPositive ? "correct its header: spacings are in mm"
                        : "correct its header: spacings must be positive");
    }
  }
}

double DeviationOf(const Eigen::Matrix3d& direction)
{
  const Eigen::Matrix3d gram = direction.transpose() * direction;
  return (gram - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
}

// Axes that are perpendicular up to single precision (no voxel of a 400 mm volume moves by 0.05
// mm).
constexpr double Exact = 1e-15;
constexpr double SinglePrecision = 1e-4;

// The largest distance from the centre of the volume to a voxel along each axis, mm.
Vector3 HalfExtent(const ImageGrid& grid)
{
  const Vector3 size(grid.Size[0], grid.Size[1], grid.Size[2]);
  return 0.5 * (size - Vector3::Ones()).cwiseProduct(grid.Spacing);
}

struct VoxelShift
{
  double Voxels = 0.0;   // largest along an axis, in voxels of that axis
  double Distance = 0.0; // mm
};

// How far voxels move if `grid` gets the axes `direction` around its centre. Linear, so that a
// corner moves farthest.
VoxelShift ShiftTo(const Eigen::Matrix3d& direction, const ImageGrid& grid)
{
  const Vector3 half = HalfExtent(grid);
  VoxelShift shift;
  for (int corner = 0; corner < 4; ++corner)
  {
    const Vector3 signs(corner % 2 == 0 ? 1.0 : -1.0, corner / 2 == 0 ? 1.0 : -1.0, 1.0);
    const Vector3 moved = (grid.Direction - direction) * signs.cwiseProduct(half);
    const Vector3 along = (direction.transpose() * moved).cwiseQuotient(grid.Spacing);
    shift.Voxels = std::max(shift.Voxels, along.cwiseAbs().maxCoeff());
    shift.Distance = std::max(shift.Distance, moved.norm());
  }
  return shift;
}

void StraightenAxes(const std::filesystem::path& file, ImageGrid& grid,
                    std::vector<std::string>& notes, ShearedAxes sheared)
{
  const double deviation = DeviationOf(grid.Direction);
  if (deviation <= Exact)
  {
    return;
  }
  const Eigen::Matrix3d nearest = SingularValuesOf(grid.Direction).NearestOrthogonal();
  if (deviation <= SinglePrecision)
  {
    grid.Direction = nearest;
    return;
  }
  constexpr double MostVoxels = 0.1;
  const VoxelShift shift = ShiftTo(nearest, grid);
  if (shift.Voxels <= MostVoxels)
  {
    const Vector3 half = HalfExtent(grid);
    grid.OriginWorld += (grid.Direction - nearest) * half;
    grid.Direction = nearest;
    notes.push_back("The axes are not exactly perpendicular, as if rounded; the nearest rotation "
                    "was used, which moves voxels by at most " +
                    SignificantText(shift.Distance, 2) + " mm.");
    return;
  }
  if (sheared == ShearedAxes::Refuse)
  {
    Refuse(file,
           "has sheared axes: they are not perpendicular (off by " + SignificantText(deviation) +
               "), and the nearest rotation would move voxels by " +
               SignificantText(shift.Distance, 2) + " mm",
           "resample it with palpate convert --resample");
  }
  grid.Direction.colwise().normalize();
}
} // namespace

void CheckGrid(const std::filesystem::path& file, ImageGrid& grid, std::vector<std::string>& notes,
               ShearedAxes sheared)
{
  CheckSize(file, grid);
  CheckSpacing(file, grid);
  if (!grid.OriginWorld.allFinite() || !grid.Direction.allFinite())
  {
    Refuse(file, "has an origin or direction that is not finite", "correct its header");
  }
  const bool isFlat = !(std::abs(grid.Direction.determinant()) > SinglePrecision);
  StraightenAxes(file, grid, notes, isFlat ? ShearedAxes::Refuse : sheared);
  if (const std::string note = SizeNote(grid); !note.empty())
  {
    notes.push_back(note);
  }
}

bool IsSheared(const ImageGrid& grid)
{
  return DeviationOf(grid.Direction) > SinglePrecision;
}

std::string SizeNote(const ImageGrid& grid)
{
  constexpr double Smallest = 2.0; // mm
  constexpr double Largest = 3000.0;
  const Vector3 size(grid.Size[0], grid.Size[1], grid.Size[2]);
  const double extent = size.cwiseProduct(grid.Spacing).maxCoeff();
  if (extent >= Smallest && extent <= Largest)
  {
    return {};
  }
  return "The volume is " + SignificantText(extent, 3) +
         " mm long, which no patient's is; check the unit of its header (mm).";
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

bool IsSameGrid(const ImageGrid& a, const ImageGrid& b)
{
  constexpr double Tolerance = 1e-3; // of a voxel
  const double voxel = a.Spacing.minCoeff();
  const double extent = Vector3(a.Size[0], a.Size[1], a.Size[2]).maxCoeff();
  return a.Size == b.Size && (a.OriginWorld - b.OriginWorld).norm() <= Tolerance * voxel &&
         (a.Spacing - b.Spacing).norm() * extent <= Tolerance * voxel &&
         (a.Direction - b.Direction).norm() * extent <= Tolerance;
}
} // namespace palpate
