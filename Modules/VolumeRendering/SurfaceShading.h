#pragma once

#include "PalpateVolumeRenderingModule.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// A light of the scene, in world coordinates.
struct SurfaceLight
{
  bool IsPositional = false;
  Vector3 Place = Vector3::UnitZ();  ///< its position (mm), or the direction towards it (unit)
  Vector3 Diffuse = Vector3::Ones(); ///< colours times intensity, 0..1
  Vector3 Specular = Vector3::Ones();
};

/// Reflection coefficients of a surface, as in vtkVolumeProperty.
struct SurfaceFinish
{
  bool IsShaded = true;
  double Ambient = 0.1;
  double Diffuse = 0.9;
  double Specular = 0.2;
  double SpecularPower = 10.0;
};

/// Colours of surface points by Phong's reflection model, two-sided. Evaluated for every pixel, so
/// everything that does not depend on the pixel is precomputed.
/// Source: Phong, "Illumination for computer generated pictures", Comm. ACM 18 (1975).
class PALPATEVOLUMERENDERING_EXPORT SurfaceShading
{
public:
  SurfaceShading(const SurfaceFinish& finish, const std::vector<SurfaceLight>& lights);

  /// Whether colours depend on the position of a point, and not only on its normal.
  bool NeedsPoints() const noexcept { return this->HasPlaces; }

  /// Colour of a point (world, mm); `color` is the surface's own, 0..1, `normal` and `toEye` are
  /// unit vectors.
  Vector3 ColorAt(const Vector3& point, const Vector3& color, const Vector3& normal,
                  const Vector3& toEye) const noexcept
  {
    if (!this->Finish.IsShaded)
    {
      return color;
    }
    // Lights the side that faces the viewer.
    const Vector3 facing = normal.dot(toEye) < 0.0 ? Vector3(-normal) : normal;
    Vector3 sum = this->Finish.Ambient * color;
    for (const SurfaceLight& light : this->Lights)
    {
      const Vector3 toLight =
          light.IsPositional ? (light.Place - point).normalized().eval() : light.Place;
      const double cosine = facing.dot(toLight);
      if (cosine > 0.0)
      {
        sum += cosine * light.Diffuse.cwiseProduct(color);
        const double mirrored = (2.0 * cosine * facing - toLight).dot(toEye);
        if (mirrored > 0.0)
        {
          sum += this->Power(mirrored < 1.0 ? mirrored : 1.0) * light.Specular;
        }
      }
    }
    return sum.cwiseMin(1.0);
  }

private:
  // Specular power of a number in 0..1; integer powers, the usual case, avoid logarithms.
  double Power(double base) const noexcept
  {
    if (!this->IsWholePower)
    {
      return this->BrokenPower(base);
    }
    double result = 1.0;
    for (unsigned int left = this->WholePower; left != 0; left >>= 1)
    {
      result *= (left & 1u) != 0 ? base : 1.0;
      base *= base;
    }
    return result;
  }
  double BrokenPower(double base) const noexcept;

  SurfaceFinish Finish;
  std::vector<SurfaceLight> Lights; ///< premultiplied by the finish
  bool HasPlaces;
  bool IsWholePower;
  unsigned int WholePower = 0;
};
} // namespace palpate
