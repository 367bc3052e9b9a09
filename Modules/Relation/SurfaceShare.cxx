#include "SurfaceShare.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
// The share of a triangle where a linear function with these values at its corners is at most a
// limit: the part at the lowest corner, or all but that at the highest one.
double ShareBelow(std::array<double, 3> values, double limit)
{
  constexpr double Far = 1e100; // instead of an infinite one
  std::sort(values.begin(), values.end());
  const double low = values[0];
  const double middle = std::min(values[1], Far);
  const double high = std::min(values[2], Far);
  if (limit < low)
  {
    return 0.0;
  }
  if (limit >= high)
  {
    return 1.0;
  }
  return limit < middle ? (limit - low) / (middle - low) * (limit - low) / (high - low)
                        : 1.0 - (high - limit) / (high - low) * (high - limit) / (high - middle);
}
} // namespace

double AreaBelow(const IndexedMesh& mesh, const std::vector<double>& values, double limit)
{
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    const double share = ShareBelow({values[a], values[b], values[c]}, limit);
    if (share > 0.0)
    {
      const Vector3& corner = mesh.Points[a];
      area += share * 0.5 * (mesh.Points[b] - corner).cross(mesh.Points[c] - corner).norm();
    }
  }
  return area;
}
} // namespace palpate
