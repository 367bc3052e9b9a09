#include "PointMeasures.h"

#include <cmath>

namespace palpate
{
double PolylineLength(const std::vector<Vector3>& points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

Vector3 PolylineMiddle(const std::vector<Vector3>& points)
{
  double left = 0.5 * PolylineLength(points);
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const Vector3 part = points[i] - points[i - 1];
    if (part.norm() > 0.0 && part.norm() >= left)
    {
      return points[i - 1] + (left / part.norm()) * part;
    }
    left -= part.norm();
  }
  return points.back();
}

// Kahan's formula: the arc cosine would lose half of the digits near 0 and pi.
double AngleAt(const Vector3& vertex, const Vector3& one, const Vector3& other)
{
  const Vector3 a = one - vertex;
  const Vector3 b = other - vertex;
  const Vector3 scaledA = b.norm() * a;
  const Vector3 scaledB = a.norm() * b;
  return 2.0 * std::atan2((scaledA - scaledB).norm(), (scaledA + scaledB).norm());
}

Vector3 PlaneNormal(const Vector3& a, const Vector3& b, const Vector3& c)
{
  constexpr double LeastSine = 1e-9;
  const Vector3 normal = (b - a).cross(c - a);
  const double least = LeastSine * (b - a).norm() * (c - a).norm();
  return normal.norm() > least ? Vector3(normal.normalized()) : Vector3::Zero();
}
} // namespace palpate
