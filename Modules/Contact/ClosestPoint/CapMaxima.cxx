#include "CapMaxima.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// A cell of the central projection of a cube's surface with the same number of cells along every
// edge, numbered face by face.
struct GroupCell
{
  Vector3 Center;
  double Radius; // rad
};

Vector3 Projected(int face, double a, double b)
{
  const int axis = face / 2;
  Vector3 point;
  point[axis] = face % 2 == 0 ? 1.0 : -1.0;
  point[(axis + 1) % 3] = a;
  point[(axis + 2) % 3] = b;
  return point.normalized();
}

GroupCell CellOf(int index, int cells)
{
  const int face = index / (cells * cells);
  const int row = index / cells % cells;
  const int column = index % cells;
  const auto at = [&](double i) { return 2.0 * i / cells - 1.0; };
  const Vector3 center = Projected(face, at(row + 0.5), at(column + 0.5));
  double radius = 0.0;
  for (const double i : {0.0, 1.0})
  {
    for (const double j : {0.0, 1.0})
    {
      const Vector3 corner = Projected(face, at(row + i), at(column + j));
      radius = std::max(radius, 2.0 * std::asin(0.5 * (corner - center).norm()));
    }
  }
  return {center, radius};
}

int IndexOf(const Vector3& u, int cells) noexcept
{
  Eigen::Index axis = 0;
  const double size = u.cwiseAbs().maxCoeff(&axis);
  const double scale = 0.5 * cells / size;
  const auto place = [&](double x)
  { return std::clamp(static_cast<int>(x * scale + 0.5 * cells), 0, cells - 1); };
  const int face = 2 * static_cast<int>(axis) + (u[axis] < 0.0 ? 1 : 0);
  return (face * cells + place(u[(axis + 1) % 3])) * cells + place(u[(axis + 2) % 3]);
}

// Of all angles up to pi.
double CosineOf(double angle)
{
  return angle < M_PI ? std::cos(angle) : -2.0;
}
} // namespace

CapMaxima::CapMaxima(const std::vector<Vector3>& directions, const std::vector<double>& values,
                     const Angles& angles, double margin, int cells)
    : Reaches(angles), Cells(cells), Largest(static_cast<std::size_t>(6 * cells * cells), Maxima{})
{
  constexpr double Slack = 1e-6; // rad, for the rounding of places and cosines
  // Directions are sorted into coarse cells, so that far ones are passed over together.
  const int coarse = std::max(1, cells / 5);
  std::vector<std::vector<std::size_t>> members(static_cast<std::size_t>(6 * coarse * coarse));
  std::vector<GroupCell> groups;
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    groups.push_back(CellOf(static_cast<int>(i), coarse));
  }
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    members[static_cast<std::size_t>(IndexOf(directions[i], coarse))].push_back(i);
  }
  for (std::size_t i = 0; i < this->Largest.size(); ++i)
  {
    const auto [center, radius] = CellOf(static_cast<int>(i), cells);
    Angles least;
    for (std::size_t k = 0; k < AngleCount; ++k)
    {
      least[k] = CosineOf(angles[k] + margin + radius + Slack);
    }
    Angles largest{};
    for (std::size_t group = 0; group < groups.size(); ++group)
    {
      const double reach = angles.back() + margin + radius + groups[group].Radius + Slack;
      // A chord is shorter than its angle.
      if ((groups[group].Center - center).squaredNorm() > reach * reach)
      {
        continue;
      }
      for (const std::size_t member : members[group])
      {
        const double cosine = directions[member].dot(center);
        for (std::size_t k = 0; k < AngleCount; ++k)
        {
          largest[k] = cosine >= least[k] ? std::max(largest[k], values[member]) : largest[k];
        }
      }
    }
    for (std::size_t k = 0; k < AngleCount; ++k)
    {
      this->Largest[i][k] =
          std::nextafter(static_cast<float>(largest[k]), std::numeric_limits<float>::infinity());
    }
  }
}

double CapMaxima::Within(const Vector3& center, double angle) const noexcept
{
  if (this->Largest.empty() || !(angle <= this->Reaches.back()))
  {
    return std::numeric_limits<double>::infinity();
  }
  std::size_t k = 0;
  while (angle > this->Reaches[k])
  {
    ++k;
  }
  return this->Largest[static_cast<std::size_t>(IndexOf(center, this->Cells))][k];
}
} // namespace palpate
