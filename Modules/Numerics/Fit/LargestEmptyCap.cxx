#include "LargestEmptyCap.h"

#include "IcosahedronDirections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

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

using Corners = std::array<Vector3, 3>;

// A triangle on the sphere and where the directions stand that may be nearest to a point of it.
struct Cell
{
  Corners Points;
  double Bound; // no point of the triangle is farther from all directions
  std::size_t First;
  std::size_t Count;
};

std::array<Corners, 4> Quarters(const Corners& corners)
{
  const auto& [a, b, c] = corners;
  const Vector3 ab = (a + b).normalized();
  const Vector3 bc = (b + c).normalized();
  const Vector3 ca = (c + a).normalized();
  return {{{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}}};
}

// All triangles of one size that are still open, and those directions.
class Level
{
public:
  std::vector<Cell> Cells;
  std::vector<Vector3> Directions;

  // Looks at a triangle whose candidates are given; keeps it if it may hold something better.
  void Add(const Corners& corners, const Vector3* candidates, std::size_t count, double tolerance,
           SphericalCap& best)
  {
    const Vector3 center = (corners[0] + corners[1] + corners[2]).normalized();
    double nearest = 4.0;
    this->Chords.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Chords[i] = (candidates[i] - center).squaredNorm();
      nearest = std::min(nearest, this->Chords[i]);
    }
    const double distance = AngleOfChord(nearest);
    if (distance > best.Radius)
    {
      best = {center, distance};
    }
    double farthest = 0.0;
    for (const Vector3& corner : corners)
    {
      farthest = std::max(farthest, (corner - center).squaredNorm());
    }
    const double size = AngleOfChord(farthest);
    if (distance + size > best.Radius + tolerance)
    {
      this->Keep(corners, distance, size, candidates);
    }
  }

private:
  void Keep(const Corners& corners, double distance, double size, const Vector3* candidates)
  {
    // Twice the size: once to the point, once back. A little more for rounding.
    const double limit = SquaredChordOf(distance + 2.0 * size + 1e-6);
    Cell cell{corners, distance + size, this->Directions.size(), 0};
    for (std::size_t i = 0; i < this->Chords.size(); ++i)
    {
      if (this->Chords[i] <= limit)
      {
        this->Directions.push_back(candidates[i]);
      }
    }
    cell.Count = this->Directions.size() - cell.First;
    this->Cells.push_back(cell);
  }

  std::vector<double> Chords;
};
} // namespace

SphericalCap LargestEmptyCap(const std::vector<Vector3>& directions, double tolerance)
{
  SphericalCap best{Vector3::UnitZ(), -1.0};
  Level level;
  const IcosahedronDirections sphere(1);
  for (const auto& triangle : sphere.Triangles())
  {
    const auto corner = [&sphere, &triangle](std::size_t i)
    { return sphere.Directions()[static_cast<std::size_t>(triangle[i])]; };
    level.Add({corner(0), corner(1), corner(2)}, directions.data(), directions.size(), tolerance,
              best);
  }
  while (!level.Cells.empty())
  {
    Level next;
    for (const Cell& cell : level.Cells)
    {
      if (cell.Bound <= best.Radius + tolerance)
      {
        continue;
      }
      for (const Corners& quarter : Quarters(cell.Points))
      {
        next.Add(quarter, level.Directions.data() + cell.First, cell.Count, tolerance, best);
      }
    }
    level = std::move(next);
  }
  return best;
}
} // namespace palpate
