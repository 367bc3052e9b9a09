#include "LargestEmptyCap.h"

#include <algorithm>
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

// A triangle on the sphere and where the directions stand that may be nearest to a point of it.
struct Cell
{
  SphericalTriangle Triangle;
  double Bound; // no point of the triangle is farther from all directions
  std::size_t First;
  std::size_t Count;
};

// All triangles of one size that are still open, and those directions.
class Level
{
public:
  std::vector<Cell> Cells;
  std::vector<Vector3> Directions;

  // Looks at a triangle whose candidates are given; keeps it if it may hold something better.
  void Add(const SphericalTriangle& triangle, const Vector3* candidates, std::size_t count,
           double tolerance, SphericalCap& best)
  {
    const SphericalCap cap = triangle.Cap();
    double nearest = 4.0;
    this->Chords.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Chords[i] = (candidates[i] - cap.Center).squaredNorm();
      nearest = std::min(nearest, this->Chords[i]);
    }
    const double distance = AngleOfChord(nearest);
    if (distance > best.Radius)
    {
      best = {cap.Center, distance};
    }
    if (distance + cap.Radius > best.Radius + tolerance)
    {
      this->Keep(triangle, distance, cap.Radius, candidates);
    }
  }

private:
  void Keep(const SphericalTriangle& triangle, double distance, double size,
            const Vector3* candidates)
  {
    // Twice the size: once to the point, once back. A little more for rounding.
    const double limit = SquaredChordOf(distance + 2.0 * size + 1e-6);
    Cell cell{triangle, distance + size, this->Directions.size(), 0};
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
  for (const SphericalTriangle& face : SphericalTriangle::Icosahedron())
  {
    level.Add(face, directions.data(), directions.size(), tolerance, best);
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
      for (const SphericalTriangle& quarter : cell.Triangle.Split())
      {
        next.Add(quarter, level.Directions.data() + cell.First, cell.Count, tolerance, best);
      }
    }
    level = std::move(next);
  }
  return best;
}
} // namespace palpate
