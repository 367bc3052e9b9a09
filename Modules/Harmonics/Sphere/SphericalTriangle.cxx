#include "SphericalTriangle.h"

#include "IcosahedronDirections.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
std::vector<SphericalTriangle> SphericalTriangle::Icosahedron()
{
  const IcosahedronDirections icosahedron(1);
  std::vector<SphericalTriangle> faces;
  for (const std::array<int, 3>& face : icosahedron.Triangles())
  {
    const auto corner = [&](std::size_t i)
    { return icosahedron.Directions()[static_cast<std::size_t>(face[i])]; };
    faces.push_back({{corner(0), corner(1), corner(2)}});
  }
  return faces;
}

SphericalCap SphericalTriangle::Cap() const noexcept
{
  const Vector3 center = (this->Corners[0] + this->Corners[1] + this->Corners[2]).normalized();
  double chord = 0.0;
  for (const Vector3& corner : this->Corners)
  {
    chord = std::max(chord, (corner - center).norm());
  }
  // A cap smaller than a hemisphere is convex: it contains the triangle if it contains the corners.
  return {center, 2.0 * std::asin(0.5 * chord) * (1.0 + 1e-12) + 1e-14};
}

std::array<SphericalTriangle, 4> SphericalTriangle::Split() const noexcept
{
  const auto& [a, b, c] = this->Corners;
  const Vector3 ab = (a + b).normalized();
  const Vector3 bc = (b + c).normalized();
  const Vector3 ca = (c + a).normalized();
  return {{{{a, ab, ca}}, {{b, bc, ab}}, {{c, ca, bc}}, {{ab, bc, ca}}}};
}
} // namespace palpate
