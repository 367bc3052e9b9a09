#pragma once

#include <array>
#include <cstddef>

namespace palpate
{
/// Lighting of all drawn surfaces, polygons and fields, in images and in views. Nothing burns out:
/// ambient, diffuse and specular parts together stay below 1, and so do all lamps on one point.
struct SurfaceMaterial
{
  static constexpr double Ambient = 0.34;
  static constexpr double Diffuse = 0.58;
  static constexpr double Specular = 0.07;
  static constexpr double SpecularPower = 25.0;
  static_assert(Ambient + Diffuse + Specular < 1.0);

  /// A directional light, white, since tinted light would falsify colours that represent numbers.
  struct Lamp
  {
    double Place[3]; ///< direction relative to the camera: right, up, towards it
    double Intensity;
  };
  /// Key above the viewer's left shoulder, fill from the right, rim from behind.
  static constexpr std::array<Lamp, 3> Lamps{
      {{{-0.35, 0.45, 1.0}, 0.88}, {{0.7, -0.25, 0.65}, 0.30}, {{0.45, 0.55, -0.6}, 0.45}}};

  /// Of a vtkProperty or vtkVolumeProperty.
  template <typename Property>
  static void Set(Property* property)
  {
    property->SetAmbient(Ambient);
    property->SetDiffuse(Diffuse);
    property->SetSpecular(Specular);
    property->SetSpecularPower(SpecularPower);
  }
  /// Makes a vtkLight one of the lamps.
  template <typename Light>
  static void Set(Light* light, const Lamp& lamp)
  {
    light->SetLightTypeToCameraLight();
    light->SetPosition(lamp.Place[0], lamp.Place[1], lamp.Place[2]);
    light->SetIntensity(lamp.Intensity);
  }
};
} // namespace palpate
