#include "LargestEmptyCap.h"

#include "IcosahedronDirections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>

namespace palpate
{
namespace
{
double AngleOfChord(double squaredChord)
{
  return 2.0 * std::asin(std::min(1.0, 0.5 * std::sqrt(squaredChord)));
}

double SquaredChordOf(double angle)
{
  const double chord = 2.0 * std::sin(0.5 * std::min(angle, M_PI));
  return chord * chord;
}

// A triangle on the sphere: how far its centre is from the nearest direction, and how far any point
// of it can be.
struct Cell
{
  std::array<Vector3, 3> Corners;
  Vector3 Center;
  double Distance;
  double Bound;
  std::vector<Vector3> Candidates; // that may be nearest to a point of the triangle

  bool operator<(const Cell& other) const { return this->Bound < other.Bound; }
};

Cell MakeCell(const std::array<Vector3, 3>& corners, const std::vector<Vector3>& directions)
{
  Cell cell{corners, (corners[0] + corners[1] + corners[2]).normalized(), M_PI, M_PI, {}};
  double farthest = 0.0;
  for (const Vector3& corner : corners)
  {
    farthest = std::max(farthest, (corner - cell.Center).squaredNorm());
  }
  double nearest = 4.0;
  for (const Vector3& direction : directions)
  {
    nearest = std::min(nearest, (direction - cell.Center).squaredNorm());
  }
  const double size = AngleOfChord(farthest);
  cell.Distance = AngleOfChord(nearest);
  cell.Bound = cell.Distance + size;
  // Twice the size: once to the point, once back. A little more for rounding.
  const double limit = SquaredChordOf(cell.Distance + 2.0 * size + 1e-6);
  for (const Vector3& direction : directions)
  {
    if ((direction - cell.Center).squaredNorm() <= limit)
    {
      cell.Candidates.push_back(direction);
    }
  }
  return cell;
}

std::array<std::array<Vector3, 3>, 4> Quarters(const std::array<Vector3, 3>& corners)
{
  const auto& [a, b, c] = corners;
  const Vector3 ab = (a + b).normalized();
  const Vector3 bc = (b + c).normalized();
  const Vector3 ca = (c + a).normalized();
  return {{{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}}};
}
} // namespace

SphericalCap LargestEmptyCap(const std::vector<Vector3>& directions, double tolerance)
{
  SphericalCap best{Vector3::UnitZ(), -1.0};
  std::priority_queue<Cell> open;
  const auto add = [&best, &open, tolerance](const std::array<Vector3, 3>& corners,
                                             const std::vector<Vector3>& candidates)
  {
    Cell cell = MakeCell(corners, candidates);
    if (cell.Distance > best.Radius)
    {
      best = {cell.Center, cell.Distance};
    }
    if (cell.Bound > best.Radius + tolerance)
    {
      open.push(std::move(cell));
    }
  };
  const IcosahedronDirections sphere(1);
  for (const auto& triangle : sphere.Triangles())
  {
    const auto corner = [&sphere, &triangle](std::size_t i)
    { return sphere.Directions()[static_cast<std::size_t>(triangle[i])]; };
    add({corner(0), corner(1), corner(2)}, directions);
  }
  while (!open.empty() && open.top().Bound > best.Radius + tolerance)
  {
    const Cell cell = open.top();
    open.pop();
    for (const auto& quarter : Quarters(cell.Corners))
    {
      add(quarter, cell.Candidates);
    }
  }
  return best;
}
} // namespace palpate
