#include "NiftiOrientation.h"

#include "Refusal.h"

#include <algorithm>

namespace palpate
{
namespace
{
double LargestCornerDistance(const Eigen::Matrix<double, 3, 4>& formWorld, const ImageGrid& grid)
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

void NoteDifference(const std::string& name, int code, const Eigen::Matrix<double, 3, 4>& formWorld,
                    const ImageGrid& grid, std::vector<std::string>& notes)
{
  const double distance = code > 0 ? LargestCornerDistance(formWorld, grid) : 0.0;
  if (distance > 0.5 * grid.Spacing.minCoeff())
  {
    notes.push_back("The file's " + name + " (code " + std::to_string(code) +
                    ") would place voxels up to " + NumberText(distance) +
                    " mm elsewhere; the other orientation was used, as ITK does.");
  }
}
} // namespace

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
