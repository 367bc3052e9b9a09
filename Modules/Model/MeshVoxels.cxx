#include "MeshVoxels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
constexpr int MarginCubes = 2; // cubes on each side

// The same voxels, numbered along `axis` first, from its end if reversed.
VoxelCenters TurnedTo(const VoxelCenters& grid, int axis, bool isReversed)
{
  VoxelCenters turned = grid;
  for (int k = 0; k < 3; ++k)
  {
    turned.Axes.col(k) = grid.Axes.col((axis + k) % 3);
    turned.Size[static_cast<std::size_t>(k)] = grid.Size[static_cast<std::size_t>((axis + k) % 3)];
  }
  if (isReversed)
  {
    turned.Origin += (turned.Size[0] - 1) * turned.Axes.col(0);
    turned.Axes.col(0) *= -1.0;
  }
  return turned;
}

// Adds 1 to each voxel that is inside by the numbers of a turned grid.
void AddVotes(const std::vector<std::int16_t>& numbers, const VoxelCenters& grid, int axis,
              bool isReversed, std::vector<std::uint8_t>& votes)
{
  const std::array<std::ptrdiff_t, 3> steps{
      1, grid.Size[0], static_cast<std::ptrdiff_t>(grid.Size[0]) * grid.Size[1]};
  const auto at = [axis](const auto& values, int k)
  { return values[static_cast<std::size_t>((axis + k) % 3)]; };
  const std::int16_t* number = numbers.data();
  for (int k = 0; k < at(grid.Size, 2); ++k)
  {
    for (int j = 0; j < at(grid.Size, 1); ++j)
    {
      const int length = at(grid.Size, 0);
      const std::ptrdiff_t step = isReversed ? -at(steps, 0) : at(steps, 0);
      std::ptrdiff_t place =
          k * at(steps, 2) + j * at(steps, 1) + (isReversed ? (length - 1) * at(steps, 0) : 0);
      for (int i = 0; i < length; ++i, ++number, place += step)
      {
        votes[static_cast<std::size_t>(place)] += *number != 0 ? 1 : 0;
      }
    }
  }
}
} // namespace

VoxelCenters CubesAround(const IndexedMesh& mesh, double voxels)
{
  Vector3 low = Vector3::Zero();
  Vector3 high = Vector3::Zero();
  if (!mesh.Points.empty())
  {
    low = high = mesh.Points.front();
  }
  for (const Vector3& point : mesh.Points)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  // A flat box gets cubes too.
  const Vector3 size = (high - low).cwiseMax(std::max(1e-3 * (high - low).maxCoeff(), 1e-9));
  const double side = std::cbrt(size.prod() / voxels);
  VoxelCenters grid;
  grid.Axes = side * Matrix3::Identity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const int count = static_cast<int>(std::ceil(size[axis] / side)) + 2 * MarginCubes;
    grid.Size[static_cast<std::size_t>(axis)] = count;
    grid.Origin[axis] = 0.5 * (low[axis] + high[axis]) - 0.5 * (count - 1) * side;
  }
  return grid;
}

Status FindInside(const IndexedMesh& mesh, const VoxelCenters& grid, bool isConsistent,
                  std::vector<std::uint8_t>& inside)
{
  std::vector<std::int16_t> numbers;
  std::vector<std::uint8_t> votes;
  const int directions = isConsistent ? 1 : 6;
  for (int direction = 0; direction < directions; ++direction)
  {
    const int axis = direction / 2;
    const bool isReversed = direction % 2 == 1;
    Status status = FindWindingNumbers(mesh, TurnedTo(grid, axis, isReversed), numbers);
    if (!status.IsOk())
    {
      return status;
    }
    votes.resize(numbers.size(), 0);
    AddVotes(numbers, grid, axis, isReversed, votes);
  }
  const int least = isConsistent ? 1 : 4;
  for (std::uint8_t& vote : votes)
  {
    vote = vote >= least ? 1 : 0;
  }
  inside = std::move(votes);
  return Status::Success();
}

double IrregularShare(const IndexedMesh& mesh)
{
  constexpr double Voxels = 2e5;
  std::vector<std::int16_t> numbers;
  if (!FindWindingNumbers(mesh, CubesAround(mesh, Voxels), numbers).IsOk())
  {
    return 0.0;
  }
  const auto outside = std::count(numbers.begin(), numbers.end(), 0);
  const auto once = std::count(numbers.begin(), numbers.end(), 1);
  const auto enclosed = static_cast<double>(numbers.size()) - static_cast<double>(outside);
  return enclosed > 0.0 ? 1.0 - static_cast<double>(once) / enclosed : 0.0;
}
} // namespace palpate
