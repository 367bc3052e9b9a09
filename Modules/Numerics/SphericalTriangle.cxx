#include "SphericalTriangle.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
Vector3 SphericalTriangle::Center() const noexcept
{
  return (this->Corners[0] + this->Corners[1] + this->Corners[2]).normalized();
}

double SphericalTriangle::Reach() const noexcept
{
  const Vector3 center = this->Center();
  double chord = 0.0;
  for (const Vector3& corner : this->Corners)
  {
    chord = std::max(chord, (corner - center).norm());
  }
  return 2.0 * std::asin(0.5 * chord);
}

std::array<SphericalTriangle, 4> SphericalTriangle::Split() const noexcept
{
  const auto& [a, b, c] = this->Corners;
  const Vector3 ab = (a + b).normalized();
  const Vector3 bc = (b + c).normalized();
  const Vector3 ca = (c + a).normalized();
  return {{{{a, ab, ca}}, {{ab, b, bc}}, {{ca, bc, c}}, {{ab, bc, ca}}}};
}
} // namespace palpate
