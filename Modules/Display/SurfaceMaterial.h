#pragma once

namespace palpate
{
/// Lighting properties of all drawn surfaces, polygons and fields, in images and in views.
struct SurfaceMaterial
{
  static constexpr double Ambient = 0.4;
  static constexpr double Diffuse = 0.62;
  static constexpr double Specular = 0.12;
  static constexpr double SpecularPower = 25.0;
  /// Ambient of what the user has selected: brighter, with its own colour and shading.
  static constexpr double HighlightAmbient = 0.7;
  /// Direction of the light relative to the camera: above the viewer's left shoulder. It is white,
  /// since tinted light would falsify colours that represent numbers.
  static constexpr double Lamp[3] = {-0.35, 0.45, 1.0};

  /// Of a vtkProperty or vtkVolumeProperty.
  template <typename Property>
  static void Set(Property* property)
  {
    property->SetAmbient(Ambient);
    property->SetDiffuse(Diffuse);
    property->SetSpecular(Specular);
    property->SetSpecularPower(SpecularPower);
  }
};
} // namespace palpate
