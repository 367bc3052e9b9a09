#include "WindingNumbers.h"

#include "ExactSign.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr double MostVoxels = 8'589'934'592.0; // 2^33
constexpr double MostGridSteps = 1e15;         // integers of this size are exact
constexpr double LeastSteps = 1e-70;           // see ExactSign

Status CheckCenters(const VoxelCenters& centers)
{
  const auto [ni, nj, nk] = centers.Size;
  if (std::min({ni, nj, nk}) < 1 || static_cast<double>(ni) * nj * nk > MostVoxels)
  {
    return Status::Failure("The voxel grid is empty or has more than 2^33 voxels.");
  }
  const double volume = std::abs(centers.Axes.determinant());
  const double steps = centers.Axes.colwise().norm().prod();
  if (!centers.Origin.allFinite() || !centers.Axes.allFinite() || !(volume > 1e-9 * steps))
  {
    return Status::Failure("The voxel grid's origin and axes are not finite or span no volume.");
  }
  return Status::Success();
}

// The mesh's points in steps of the grid.
Status ToSteps(const IndexedMesh& mesh, const VoxelCenters& centers, std::vector<Vector3>& points)
{
  const Matrix3 inverse = centers.Axes.inverse();
  points.reserve(mesh.Points.size());
  for (const Vector3& point : mesh.Points)
  {
    Vector3 p = inverse * (point - centers.Origin);
    if (!(p.cwiseAbs().maxCoeff() <= MostGridSteps) || !p.allFinite())
    {
      return Status::Failure("The mesh has points that are not finite or too far from the grid.");
    }
    points.push_back((p.array().abs() < LeastSteps).select(Vector3::Zero(), p));
  }
  const int count = static_cast<int>(points.size());
  const auto isValid = [count](const std::array<int, 3>& t)
  { return std::all_of(t.begin(), t.end(), [count](int p) { return p >= 0 && p < count; }); };
  return std::all_of(mesh.Triangles.begin(), mesh.Triangles.end(), isValid)
             ? Status::Success()
             : Status::Failure("The mesh has triangles with invalid point indices.");
}

// The integers from the first not below `least` to before the first above `most`, within [0, size].
struct CellRange
{
  int Begin;
  int End;
  CellRange(double least, double most, int size)
      : Begin(static_cast<int>(std::clamp(std::ceil(least), 0.0, static_cast<double>(size)))),
        End(static_cast<int>(std::clamp(std::floor(most) + 1.0, 0.0, static_cast<double>(size))))
  {
  }
};

CellRange RangeOf(double a, double b, double c, int size)
{
  return {std::min({a, b, c}), std::max({a, b, c}), size};
}

// The side of a grid line along i, moved as explained in the header, of an edge seen along i.
int SideOf(const Vector3& from, const Vector3& to, const exact::Point2& line)
{
  const int side = exact::AreaSign({from[1], from[2]}, {to[1], to[2]}, line);
  if (side != 0)
  {
    return side;
  }
  if (from[2] != to[2])
  {
    return to[2] < from[2] ? 1 : -1;
  }
  return (to[1] > from[1] ? 1 : 0) - (to[1] < from[1] ? 1 : 0);
}

/// Adds a triangle's crossings with grid lines to the voxels from which on they count.
class CrossingCounter
{
public:
  CrossingCounter(const VoxelCenters& centers, std::vector<std::int16_t>& numbers)
      : Size(centers.Size), Forward(centers.Axes.determinant() > 0.0 ? 1 : -1), Numbers(numbers)
  {
  }

  void Add(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const CellRange rows = RangeOf(a[1], b[1], c[1], this->Size[1]);
    const CellRange slices = RangeOf(a[2], b[2], c[2], this->Size[2]);
    for (int k = slices.Begin; k < slices.End; ++k)
    {
      for (int j = rows.Begin; j < rows.End; ++j)
      {
        const exact::Point2 line{static_cast<double>(j), static_cast<double>(k)};
        const int side = SideOf(a, b, line);
        if (side != 0 && side == SideOf(b, c, line) && side == SideOf(c, a, line))
        {
          this->Count(a, b, c, j, k, side);
        }
      }
    }
  }

private:
  // side is that of the normal along i: the line enters where it points backwards.
  void Count(const Vector3& a, const Vector3& b, const Vector3& c, int j, int k, int side)
  {
    const int i = this->FirstBehind(a, b, c, j, k, side);
    if (i < this->Size[0])
    {
      const std::size_t row = static_cast<std::size_t>(k) * this->Size[1] + j;
      std::int16_t& number = this->Numbers[row * this->Size[0] + i];
      number = static_cast<std::int16_t>(number - side * this->Forward);
    }
  }

  // The first i at which the line has reached the triangle's plane, or the size.
  int FirstBehind(const Vector3& a, const Vector3& b, const Vector3& c, int j, int k,
                  int side) const
  {
    const exact::Plane plane(a, b, c);
    const auto isBehind = [&](int i) { return plane.SideOf(Vector3(i, j, k)) * side >= 0; };
    const CellRange range = RangeOf(a[0], b[0], c[0], this->Size[0]);
    const Vector3 normal = (b - a).cross(c - a);
    const double at = a[0] - (normal[1] * (j - a[1]) + normal[2] * (k - a[2])) / normal[0];
    int first = range.Begin;
    int last = range.End; // behind, or the size
    const int guess = at > first ? static_cast<int>(std::min<double>(std::ceil(at), last)) : first;
    if ((guess == first || !isBehind(guess - 1)) && (guess == last || isBehind(guess)))
    {
      return guess;
    }
    while (first < last)
    {
      const int middle = first + (last - first) / 2;
      (isBehind(middle) ? last : first) = isBehind(middle) ? middle : middle + 1;
    }
    return last;
  }

  std::array<int, 3> Size;
  int Forward; // whether the axes are right-handed
  std::vector<std::int16_t>& Numbers;
};

// Modulo 2^16, so that sums on the way may be larger than the result.
void SumUp(int rowSize, std::vector<std::int16_t>& numbers)
{
  for (auto row = numbers.begin(); row != numbers.end(); row += rowSize)
  {
    std::uint16_t sum = 0;
    for (auto number = row; number != row + rowSize; ++number)
    {
      sum = static_cast<std::uint16_t>(sum + static_cast<std::uint16_t>(*number));
      *number = static_cast<std::int16_t>(sum);
    }
  }
}
} // namespace

Status FindWindingNumbers(const IndexedMesh& mesh, const VoxelCenters& centers,
                          std::vector<std::int16_t>& numbers)
{
  if (Status status = CheckCenters(centers); !status.IsOk())
  {
    return status;
  }
  std::vector<Vector3> points;
  if (Status status = ToSteps(mesh, centers, points); !status.IsOk())
  {
    return status;
  }
  const auto [ni, nj, nk] = centers.Size;
  numbers.assign(static_cast<std::size_t>(ni) * nj * nk, 0);
  CrossingCounter counter(centers, numbers);
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    counter.Add(points[t[0]], points[t[1]], points[t[2]]);
  }
  SumUp(ni, numbers);
  return Status::Success();
}

WindingOverlap CompareWithMask(const std::vector<std::int16_t>& numbers, const std::uint8_t* mask)
{
  WindingOverlap overlap;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const int number = numbers[i];
    const bool isInside = number > 0;
    const bool isInMask = mask[i] != 0;
    overlap.Inside += isInside ? 1 : 0;
    overlap.Mask += isInMask ? 1 : 0;
    overlap.Both += isInside && isInMask ? 1 : 0;
    overlap.Irregular += number != 0 && number != 1 ? 1 : 0;
  }
  return overlap;
}

Status CheckRegularity(const WindingOverlap& overlap)
{
  if (overlap.IrregularPercent() <= LargestIrregularPercent)
  {
    return Status::Success();
  }
  char text[120];
  std::snprintf(text, sizeof(text),
                "overlaps itself in %.3g %% of the voxels (at most %g %%); another degree may not",
                overlap.IrregularPercent(), LargestIrregularPercent);
  return Status::Failure(text);
}
} // namespace palpate
