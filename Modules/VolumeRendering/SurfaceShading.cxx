#include "SurfaceShading.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// The power of a number in 0..1; whole powers, which are usual, without logarithms.
double Power(double base, double exponent) noexcept
{
  constexpr double MostFactors = 256.0;
  if (!(exponent >= 0.0 && exponent <= MostFactors) || std::floor(exponent) != exponent)
  {
    return std::pow(base, exponent);
  }
  double result = 1.0;
  for (auto left = static_cast<unsigned int>(exponent); left != 0; left >>= 1)
  {
    result *= (left & 1u) != 0 ? base : 1.0;
    base *= base;
  }
  return result;
}
} // namespace

Vector3 ShadedColor(const Vector3& color, const SurfaceFinish& finish,
                    const std::vector<SurfaceLight>& lights, const Vector3& point,
                    const Vector3& normal, const Vector3& toEye) noexcept
{
  if (!finish.IsShaded)
  {
    return color;
  }
  // The side that is seen is the one that is lit.
  const Vector3 facing = normal.dot(toEye) < 0.0 ? Vector3(-normal) : normal;
  Vector3 sum = finish.Ambient * color;
  for (const SurfaceLight& light : lights)
  {
    const Vector3 toLight =
        light.IsPositional ? (light.Place - point).normalized().eval() : light.Place;
    const double cosine = facing.dot(toLight);
    if (cosine > 0.0)
    {
      sum += finish.Diffuse * cosine * light.Diffuse.cwiseProduct(color);
      const double mirrored = (2.0 * cosine * facing - toLight).dot(toEye);
      if (finish.Specular > 0.0 && mirrored > 0.0)
      {
        sum +=
            finish.Specular * Power(std::min(1.0, mirrored), finish.SpecularPower) * light.Specular;
      }
    }
  }
  return sum.cwiseMin(1.0);
}
} // namespace palpate
