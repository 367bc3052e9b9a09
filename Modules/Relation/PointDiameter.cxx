#include "PointDiameter.h"

#include "IcosahedronDirections.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
constexpr int DirectionFrequency = 8; // 642 directions, any direction within 5 degrees of one
constexpr double CosineBetween = 0.996;

struct PointWidth
{
  double Width = 0.0;
  std::size_t End = 0;
};

PointWidth WidthAlong(const std::vector<Vector3>& points, const Vector3& direction)
{
  double low = direction.dot(points.front());
  PointWidth found{low, 0};
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double along = direction.dot(points[i]);
    low = std::min(low, along);
    if (along > found.Width)
    {
      found = {along, i};
    }
  }
  found.Width -= low;
  return found;
}

std::size_t FarthestFrom(const std::vector<Vector3>& points, std::size_t from)
{
  std::size_t farthest = from;
  double most = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double squared = (points[i] - points[from]).squaredNorm();
    if (squared > most)
    {
      most = squared;
      farthest = i;
    }
  }
  return farthest;
}

double Climb(const std::vector<Vector3>& points, std::size_t from)
{
  double reached = 0.0;
  for (;;)
  {
    const std::size_t to = FarthestFrom(points, from);
    const double distance = (points[to] - points[from]).norm();
    if (!(distance > reached))
    {
      return reached;
    }
    reached = distance;
    from = to;
  }
}
} // namespace

double DiameterOf(const std::vector<Vector3>& points)
{
  if (points.empty())
  {
    return 0.0;
  }
  std::vector<PointWidth> widths;
  double widest = 0.0;
  const IcosahedronDirections sphere(DirectionFrequency);
  for (const Vector3& direction : sphere.Directions())
  {
    if (direction.z() > 0.0 || (direction.z() == 0.0 && direction.y() >= 0.0))
    {
      widths.push_back(WidthAlong(points, direction));
      widest = std::max(widest, widths.back().Width);
    }
  }
  // The diameter is at least as wide along the direction nearest to it.
  double diameter = 0.0;
  for (const PointWidth& one : widths)
  {
    if (one.Width >= CosineBetween * widest)
    {
      diameter = std::max(diameter, Climb(points, one.End));
    }
  }
  return diameter;
}
} // namespace palpate
