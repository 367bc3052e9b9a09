#include "IcosahedronDirections.h"

#include "SphericalTriangle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace palpate
{
namespace
{
constexpr int CornerCount = 12;

std::array<Vector3, CornerCount> IcosahedronCorners()
{
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  return {{{0, 1, g},
           {0, -1, g},
           {0, 1, -g},
           {0, -1, -g},
           {g, 0, 1},
           {g, 0, -1},
           {-g, 0, 1},
           {-g, 0, -1},
           {1, g, 0},
           {-1, g, 0},
           {1, -g, 0},
           {-1, -g, 0}}};
}

// The 20 triples of mutually adjacent corners (distance 2), oriented outwards.
std::vector<std::array<int, 3>> CornerFaces(const std::array<Vector3, CornerCount>& corners)
{
  const auto adjacent = [&corners](int a, int b)
  { return std::abs((corners[a] - corners[b]).squaredNorm() - 4.0) < 0.1; };
  std::vector<std::array<int, 3>> faces;
  for (int a = 0; a < CornerCount; ++a)
  {
    for (int b = a + 1; b < CornerCount; ++b)
    {
      for (int c = b + 1; c < CornerCount; ++c)
      {
        if (adjacent(a, b) && adjacent(b, c) && adjacent(a, c))
        {
          const bool outward = corners[a].dot(corners[b].cross(corners[c])) > 0.0;
          faces.push_back(outward ? std::array<int, 3>{a, b, c} : std::array<int, 3>{a, c, b});
        }
      }
    }
  }
  return faces;
}

// Assigns one index to every grid point, shared by adjacent faces.
class GridIndex
{
public:
  GridIndex(int parts, std::vector<Vector3>& points) : Parts(parts), Points(points) {}

  // Point a + (b - a) j / parts + (c - a) k / parts.
  int At(const std::array<int, 3>& face, int j, int k)
  {
    const int i = this->Parts - j - k;
    const std::array<int, 3> parts{i, j, k};
    const auto zeros = std::count(parts.begin(), parts.end(), 0);
    if (zeros == 2)
    {
      return face[static_cast<std::size_t>(std::find(parts.begin(), parts.end(), this->Parts) -
                                           parts.begin())];
    }
    if (zeros == 1)
    {
      const auto missing =
          static_cast<std::size_t>(std::find(parts.begin(), parts.end(), 0) - parts.begin());
      const std::size_t first = (missing + 1) % 3;
      const std::size_t second = (missing + 2) % 3;
      return this->OnEdge(face[first], face[second], parts[second]);
    }
    return this->Add(face, parts);
  }

private:
  // The point `step` parts from corner a towards corner b.
  int OnEdge(int a, int b, int step)
  {
    if (a > b)
    {
      std::swap(a, b);
      step = this->Parts - step;
    }
    const auto [entry, isNew] = this->Edges.try_emplace({a, b}, 0);
    if (isNew)
    {
      entry->second = static_cast<int>(this->Points.size());
      for (int k = 1; k < this->Parts; ++k)
      {
        this->Add({a, b, a}, {this->Parts - k, k, 0});
      }
    }
    return entry->second + step - 1;
  }

  int Add(const std::array<int, 3>& face, const std::array<int, 3>& parts)
  {
    const Vector3 sum = this->Points[static_cast<std::size_t>(face[0])] * parts[0] +
                        this->Points[static_cast<std::size_t>(face[1])] * parts[1] +
                        this->Points[static_cast<std::size_t>(face[2])] * parts[2];
    this->Points.push_back(sum.normalized());
    return static_cast<int>(this->Points.size()) - 1;
  }

  int Parts;
  std::vector<Vector3>& Points;
  std::map<std::pair<int, int>, int> Edges;
};

// Solid angle of the spherical triangle (a, b, c), van Oosterom and Strackee 1983.
double SolidAngle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
}
} // namespace

IcosahedronDirections::IcosahedronDirections(int frequency) : Parts(std::max(1, frequency))
{
  const std::array<Vector3, CornerCount> corners = IcosahedronCorners();
  const std::size_t square =
      static_cast<std::size_t>(this->Parts) * static_cast<std::size_t>(this->Parts);
  this->Points.reserve(10 * square + 2);
  this->Faces.reserve(20 * square);
  for (const Vector3& corner : corners)
  {
    this->Points.push_back(corner.normalized());
  }
  GridIndex grid(this->Parts, this->Points);
  for (const std::array<int, 3>& face : CornerFaces(corners))
  {
    // Rows of the face's grid; the row above is kept so that interior points are created once.
    std::vector<int> previous;
    for (int j = 0; j <= this->Parts; ++j)
    {
      std::vector<int> row;
      for (int k = 0; k <= this->Parts - j; ++k)
      {
        row.push_back(grid.At(face, j, k));
      }
      for (std::size_t k = 0; j > 0 && k < row.size(); ++k)
      {
        this->Faces.push_back({previous[k], row[k], previous[k + 1]});
        if (k + 1 < row.size())
        {
          this->Faces.push_back({row[k], row[k + 1], previous[k + 1]});
        }
      }
      previous = std::move(row);
    }
  }
}

std::vector<double> IcosahedronDirections::SolidAngles() const
{
  std::vector<double> angles(this->Points.size(), 0.0);
  for (const auto& face : this->Faces)
  {
    const auto at = [this, &face](int corner)
    { return this->Points[static_cast<std::size_t>(face[static_cast<std::size_t>(corner)])]; };
    const double third = SolidAngle(at(0), at(1), at(2)) / 3.0;
    for (const int corner : face)
    {
      angles[static_cast<std::size_t>(corner)] += third;
    }
  }
  return angles;
}

double IcosahedronDirections::LargestGap() const
{
  double gap = 0.0;
  for (const auto& [a, b, c] : this->Faces)
  {
    const auto at = [this](int corner) { return this->Points[static_cast<std::size_t>(corner)]; };
    gap = std::max(gap, SphericalTriangle{{at(a), at(b), at(c)}}.Cap().Radius);
  }
  return gap;
}
} // namespace palpate
