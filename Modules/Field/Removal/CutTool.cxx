#include "CutTool.h"

#include "PositiveNumber.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// Whether a node of number `n` lies on the border of a grid of this size.
bool IsOnBorder(std::size_t n, const std::array<int, 3>& size)
{
  for (const int count : size)
  {
    const auto nodes = static_cast<std::size_t>(count);
    const std::size_t place = n % nodes;
    if (place == 0 || place + 1 == nodes)
    {
      return true;
    }
    n /= nodes;
  }
  return false;
}
} // namespace

CutTool::CutTool(Shape kind, double radius, double halfLength)
    : Kind(kind), Radius(radius), HalfLength(halfLength), Extent(std::hypot(radius, halfLength))
{
}

CutTool CutTool::Sphere(double radius)
{
  return {Shape::Sphere, radius, 0.0};
}

CutTool CutTool::Cylinder(double radius, double length)
{
  return {Shape::Cylinder, radius, 0.5 * length};
}

CutTool CutTool::Surface(const FieldGrid& grid, std::vector<double> distances)
{
  CutTool tool(Shape::Surface, 0.0, 0.0);
  const Vector3 last(grid.Size()[0] - 1, grid.Size()[1] - 1, grid.Size()[2] - 1);
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 part(corner & 1, corner >> 1 & 1, corner >> 2);
    tool.Extent = std::max(tool.Extent, grid.PointWorld(last.cwiseProduct(part)).norm());
  }
  tool.Samples = std::make_shared<const Sampled>(Sampled{grid, std::move(distances)});
  return tool;
}

Status CutTool::Check() const
{
  if (this->Kind == Shape::Surface)
  {
    return this->CheckSamples();
  }
  const bool hasLength = this->Kind == Shape::Sphere || IsPositive(this->HalfLength);
  return IsPositive(this->Radius) && hasLength
             ? Status::Success()
             : Status::Failure("The lengths of a cutting tool are not positive numbers.");
}

Status CutTool::CheckSamples() const
{
  const FieldGrid& grid = this->Samples->Grid;
  const std::vector<double>& distances = this->Samples->Distances;
  Status status = grid.Check();
  if (!status.IsOk())
  {
    return status;
  }
  if (distances.size() != grid.NodeCount())
  {
    return Status::Failure("A cutting tool needs one distance for each node.");
  }
  bool isInside = false;
  for (std::size_t n = 0; n < distances.size(); ++n)
  {
    if (!std::isfinite(distances[n]))
    {
      return Status::Failure("The distances of a cutting tool are not all finite.");
    }
    if (distances[n] < 0.0 && IsOnBorder(n, grid.Size()))
    {
      return Status::Failure("The surface of a cutting tool reaches the border of its grid.");
    }
    isInside = isInside || distances[n] < 0.0;
  }
  return isInside ? Status::Success() : Status::Failure("A cutting tool encloses no volume.");
}

double CutTool::Distance(const Vector3& point) const noexcept
{
  switch (this->Kind)
  {
  case Shape::Sphere:
    return point.norm() - this->Radius;
  case Shape::Cylinder:
    return this->DistanceToCylinder(point);
  default:
    return this->DistanceBySamples(point);
  }
}

double CutTool::DistanceToCylinder(const Vector3& point) const noexcept
{
  const double side = std::hypot(point[0], point[1]) - this->Radius;
  const double end = std::abs(point[2]) - this->HalfLength;
  const double outside = std::hypot(std::max(side, 0.0), std::max(end, 0.0));
  return outside + std::min(std::max(side, end), 0.0);
}

double CutTool::DistanceBySamples(const Vector3& point) const noexcept
{
  const FieldGrid& grid = this->Samples->Grid;
  const Vector3 last(grid.Size()[0] - 1, grid.Size()[1] - 1, grid.Size()[2] - 1);
  const Vector3 index = grid.PointIndex(point);
  const Vector3 within = index.cwiseMax(0.0).cwiseMin(last);
  return this->Samples->At(within) + grid.VectorWorld(index - within).norm();
}

double CutTool::Sampled::At(const Vector3& pointIndex) const noexcept
{
  std::array<std::size_t, 3> first{};
  Vector3 u;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto place = static_cast<Eigen::Index>(axis);
    const int last = this->Grid.Size()[axis] - 2;
    const int cell = std::min(static_cast<int>(pointIndex[place]), last);
    first[axis] = static_cast<std::size_t>(cell);
    u[place] = pointIndex[place] - cell;
  }
  const auto row = static_cast<std::size_t>(this->Grid.Size()[0]);
  const std::size_t slice = row * static_cast<std::size_t>(this->Grid.Size()[1]);
  const double* node = &this->Distances[first[2] * slice + first[1] * row + first[0]];
  const auto along = [&u](const double* two) { return two[0] * (1.0 - u[0]) + two[1] * u[0]; };
  const auto across = [&](const double* four)
  { return along(four) * (1.0 - u[1]) + along(four + row) * u[1]; };
  return across(node) * (1.0 - u[2]) + across(node + slice) * u[2];
}
} // namespace palpate
