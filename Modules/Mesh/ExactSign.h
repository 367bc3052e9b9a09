#pragma once

#include "Vector3.h"

#include <array>
#include <cmath>

namespace palpate
{
/// Exact signs of determinants of points, after Shewchuk, Adaptive precision floating-point
/// arithmetic and fast robust geometric predicates, Discrete Comput. Geom. 18 (1997): rounded
/// arithmetic with an error bound, and where that cannot tell, expansions. Coordinates have to be 0
/// or of a size between 1e-70 and 1e100; otherwise a product can be lost below the smallest number.
namespace exact
{
/// A point of a plane, for example two coordinates of a point in space.
using Point2 = std::array<double, 2>;

/// Sign of (b - a) x (c - a) . (d - a): 1 if d lies on the side to which the normal points, seen
/// from which a, b, c are counter-clockwise; 0 if the four points are in one plane.
int VolumeSign(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) noexcept;
/// The same by expansions only, which takes microseconds.
int VolumeSignByExpansion(const Vector3& a, const Vector3& b, const Vector3& c,
                          const Vector3& d) noexcept;

/// Sign of (b - a) x (c - a): 1 if a, b, c are counter-clockwise, 0 if they are on one line.
int AreaSign(const Point2& a, const Point2& b, const Point2& c) noexcept;

/// The sides of a triangle's plane, for several points.
class Plane
{
public:
  Plane(const Vector3& a, const Vector3& b, const Vector3& c) noexcept
      : Corners{&a, &b, &c}, Base(a)
  {
    const Vector3 u = b - a;
    const Vector3 v = c - a;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      const double one = u[j] * v[k];
      const double other = u[k] * v[j];
      this->Normal[i] = one - other;
      this->Size[i] = std::abs(one) + std::abs(other);
    }
  }

  /// VolumeSign(a, b, c, point). The corners must still exist.
  int SideOf(const Vector3& point) const noexcept
  {
    const Vector3 w = point - this->Base;
    const double volume = w.dot(this->Normal);
    const double size = w.cwiseAbs().dot(this->Size);
    // Shewchuk's bound (7 + 56 e) e, e = 2^-53; far above it underflow is not possible.
    if (size > 1e-200 && std::abs(volume) > 7.7715611723761027e-16 * size)
    {
      return volume > 0.0 ? 1 : -1;
    }
    return VolumeSignByExpansion(*this->Corners[0], *this->Corners[1], *this->Corners[2], point);
  }

private:
  std::array<const Vector3*, 3> Corners;
  Vector3 Base;
  Vector3 Normal;
  Vector3 Size; // of the products in Normal
};

inline int VolumeSign(const Vector3& a, const Vector3& b, const Vector3& c,
                      const Vector3& d) noexcept
{
  return Plane(a, b, c).SideOf(d);
}
} // namespace exact
} // namespace palpate
