#pragma once

namespace palpate
{
/// How drawn surfaces answer to light, polygons and fields alike, in pictures and in views.
struct SurfaceMaterial
{
  static constexpr double Ambient = 0.4;
  static constexpr double Diffuse = 0.62;
  static constexpr double Specular = 0.12;
  static constexpr double SpecularPower = 25.0;
  /// Where the lamp is seen from the camera: above the viewer's left shoulder. It is white: tinted
  /// light would falsify colours that mean numbers.
  static constexpr double Lamp[3] = {-0.35, 0.45, 1.0};
};
} // namespace palpate
