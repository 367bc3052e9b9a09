#pragma once

#include "IndexedMesh.h"

#include <algorithm>
#include <array>
#include <vector>

namespace palpate::test
{
/// A reduced fraction. Enough digits for a few clips of triangles with coordinates below 16.
class Rational
{
public:
  using Integer = __int128;

  Rational(Integer numerator = 0, Integer denominator = 1) // NOLINT: converts from integers
      : Numerator(denominator < 0 ? -numerator : numerator),
        Denominator(denominator < 0 ? -denominator : denominator)
  {
    Integer a = this->Numerator < 0 ? -this->Numerator : this->Numerator;
    Integer b = this->Denominator;
    while (b != 0)
    {
      a %= b;
      std::swap(a, b);
    }
    this->Numerator /= a;
    this->Denominator /= a;
  }

  int Sign() const { return this->Numerator > 0 ? 1 : this->Numerator < 0 ? -1 : 0; }
  friend Rational operator+(const Rational& a, const Rational& b)
  {
    return {a.Numerator * b.Denominator + b.Numerator * a.Denominator,
            a.Denominator * b.Denominator};
  }
  friend Rational operator-(const Rational& a, const Rational& b)
  {
    return a + Rational(-b.Numerator, b.Denominator);
  }
  friend Rational operator*(const Rational& a, const Rational& b)
  {
    return {a.Numerator * b.Numerator, a.Denominator * b.Denominator};
  }
  friend Rational operator/(const Rational& a, const Rational& b)
  {
    return {a.Numerator * b.Denominator, a.Denominator * b.Numerator};
  }

private:
  Integer Numerator;
  Integer Denominator;
};

using RationalVector = std::array<Rational, 3>;

inline RationalVector operator-(const RationalVector& a, const RationalVector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Rational Dot(const RationalVector& a, const RationalVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline RationalVector Cross(const RationalVector& a, const RationalVector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline bool IsZero(const RationalVector& a)
{
  return a[0].Sign() == 0 && a[1].Sign() == 0 && a[2].Sign() == 0;
}

using RationalPolygon = std::vector<RationalVector>;

/// The part of a convex polygon where normal . (p - from) >= 0 (Sutherland and Hodgman).
inline RationalPolygon Clip(const RationalPolygon& polygon, const RationalVector& from,
                            const RationalVector& normal)
{
  RationalPolygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const RationalVector& p = polygon[i];
    const RationalVector& q = polygon[(i + 1) % polygon.size()];
    const Rational atP = Dot(normal, p - from);
    const Rational atQ = Dot(normal, q - from);
    if (atP.Sign() >= 0)
    {
      kept.push_back(p);
    }
    if (atP.Sign() * atQ.Sign() < 0)
    {
      const Rational part = atP / (atP - atQ);
      const RationalVector step = q - p;
      kept.push_back({p[0] + part * step[0], p[1] + part * step[1], p[2] + part * step[2]});
    }
  }
  return kept;
}

/// TrianglesCross for integer coordinates by clipping one triangle with the other's plane and
/// edges: another method than the tested one, in rational arithmetic.
inline bool TrianglesCrossByClipping(const IndexedMesh& mesh, int one, int other)
{
  const auto corner = [&mesh](int p)
  {
    const Vector3& at = mesh.Points[p];
    return RationalVector{static_cast<Rational::Integer>(at[0]),
                          static_cast<Rational::Integer>(at[1]),
                          static_cast<Rational::Integer>(at[2])};
  };
  const auto& t = mesh.Triangles[one];
  const auto& u = mesh.Triangles[other];
  const RationalPolygon a{corner(t[0]), corner(t[1]), corner(t[2])};
  RationalPolygon common{corner(u[0]), corner(u[1]), corner(u[2])};
  const RationalVector normal = Cross(a[1] - a[0], a[2] - a[0]);
  common = Clip(common, a[0], normal);
  common = Clip(common, a[0], Cross(a[2] - a[0], a[1] - a[0]));
  for (std::size_t k = 0; k < 3; ++k)
  {
    common = Clip(common, a[k], Cross(normal, a[(k + 1) % 3] - a[k]));
  }
  RationalPolygon shared;
  for (const int p : t)
  {
    if (std::find(u.begin(), u.end(), p) != u.end())
    {
      shared.push_back(corner(p));
    }
  }
  const auto isShared = [&shared](const RationalVector& p)
  {
    return shared.size() == 1   ? IsZero(p - shared[0])
           : shared.size() == 2 ? IsZero(Cross(p - shared[0], shared[1] - shared[0])) &&
                                      Dot(p - shared[0], p - shared[1]).Sign() <= 0
                                : false;
  };
  return !std::all_of(common.begin(), common.end(), isShared);
}
} // namespace palpate::test
