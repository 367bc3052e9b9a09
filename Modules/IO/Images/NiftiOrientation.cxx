#include "NiftiOrientation.h"

#include "DecimalText.h"
#include "Refusal.h"

#include <algorithm>

namespace palpate
{
namespace
{
using Form = Eigen::Matrix<double, 3, 4>;

// ITK's tolerances: mm, between unit vectors, and of matrix entries.
constexpr double SpacingTolerance = 1e-3;
constexpr double ShearTolerance = 1e-4;
constexpr double EqualFormTolerance = 1e-4;

Eigen::Matrix3d UnitColumns(const Form& formWorld)
{
  return formWorld.leftCols<3>().colwise().normalized();
}

bool HasSpacing(const Form& formWorld, const Vector3& spacing)
{
  const Vector3 lengths = formWorld.leftCols<3>().colwise().norm().transpose();
  return (lengths - spacing).cwiseAbs().maxCoeff() <= SpacingTolerance;
}

// Whether voxel sizes differ so far that a voxel of the volume would move by a tenth of one.
bool HasOtherSizes(const Form& formWorld, const ImageGrid& grid)
{
  constexpr double MostVoxels = 0.1;
  const Vector3 lengths = formWorld.leftCols<3>().colwise().norm().transpose();
  const Vector3 half(0.5 * grid.Size[0], 0.5 * grid.Size[1], 0.5 * grid.Size[2]);
  const Vector3 voxels = (lengths.cwiseQuotient(grid.Spacing) - Vector3::Ones()).cwiseProduct(half);
  return !HasSpacing(formWorld, grid.Spacing) && !(voxels.cwiseAbs().maxCoeff() <= MostVoxels);
}

bool IsPerpendicular(const Form& formWorld)
{
  const Eigen::Matrix3d axes = UnitColumns(formWorld);
  return (axes.transpose() * axes).isIdentity(ShearTolerance);
}

bool UsesSForm(const NiftiOrientation& orientation, const Vector3& spacing)
{
  if (orientation.QFormCode <= 0 || orientation.SFormCode <= 0)
  {
    return orientation.SFormCode > 0;
  }
  const bool isRigid =
      HasSpacing(orientation.SFormWorld, spacing) && IsPerpendicular(orientation.SFormWorld);
  const Form difference = orientation.SFormWorld - orientation.QFormWorld;
  const bool areEqual = difference.cwiseAbs().maxCoeff() <= EqualFormTolerance;
  return isRigid && (orientation.SFormCode == 1 || areEqual);
}

double LargestCornerDistance(const Form& formWorld, const ImageGrid& grid)
{
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3 index;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int last = grid.Size[static_cast<std::size_t>(axis)] - 1;
      index[axis] = (corner >> axis) % 2 == 0 ? 0 : last;
    }
    const Vector3 used = grid.OriginWorld + grid.Direction * index.cwiseProduct(grid.Spacing);
    largest = std::max(largest, (formWorld * index.homogeneous() - used).norm());
  }
  return largest;
}

void NoteDifference(const std::string& name, int code, const Form& formWorld, const ImageGrid& grid,
                    std::vector<std::string>& notes)
{
  const double distance = code > 0 ? LargestCornerDistance(formWorld, grid) : 0.0;
  if (distance > 0.5 * grid.Spacing.minCoeff())
  {
    notes.push_back("The file's " + name + " (code " + std::to_string(code) +
                    ") would place voxels up to " + SignificantText(distance) +
                    " mm elsewhere; the other orientation was used, as ITK does.");
  }
}
} // namespace

void PlaceGrid(const std::filesystem::path& file, const NiftiOrientation& orientation,
               ImageGrid& grid)
{
  if (orientation.QFormCode <= 0 && orientation.SFormCode <= 0)
  {
    grid.OriginWorld.setZero();
    grid.Direction.setIdentity();
    grid.IsOriented = false;
    return;
  }
  const bool usesSForm = UsesSForm(orientation, grid.Spacing);
  const Form& form = usesSForm ? orientation.SFormWorld : orientation.QFormWorld;
  if (usesSForm && HasOtherSizes(form, grid))
  {
    if (IsPerpendicular(form))
    {
      Refuse(file, "has different voxel sizes in its sform and its pixdim",
             "correct its header or resample it to a rectangular grid");
    }
    // Sheared: the sform alone places the voxels (see CheckGrid).
    grid.Spacing = form.leftCols<3>().colwise().norm().transpose();
  }
  grid.OriginWorld = form.col(3);
  grid.Direction = UnitColumns(form);
}

std::vector<std::string> OrientationNotes(const NiftiOrientation& orientation,
                                          const ImageGrid& grid)
{
  std::vector<std::string> notes;
  if (orientation.QFormCode <= 0 && orientation.SFormCode <= 0)
  {
    notes.emplace_back("The file gives no orientation; its index axes were taken as L, P, S.");
  }
  NoteDifference("qform", orientation.QFormCode, orientation.QFormWorld, grid, notes);
  NoteDifference("sform", orientation.SFormCode, orientation.SFormWorld, grid, notes);
  return notes;
}
} // namespace palpate
