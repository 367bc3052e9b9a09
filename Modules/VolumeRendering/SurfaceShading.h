#pragma once

#include "PalpateVolumeRenderingModule.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// A light of the scene, world.
struct SurfaceLight
{
  bool IsPositional = false;
  Vector3 Place = Vector3::UnitZ();  ///< its position (mm), or the direction towards it (unit)
  Vector3 Diffuse = Vector3::Ones(); ///< colours times intensity, 0..1
  Vector3 Specular = Vector3::Ones();
};

/// How surfaces answer to light: the coefficients of vtkVolumeProperty.
struct SurfaceFinish
{
  bool IsShaded = true;
  double Ambient = 0.1;
  double Diffuse = 0.9;
  double Specular = 0.2;
  double SpecularPower = 10.0;
};

/// The colour of a point of a surface (world, mm) by Phong's reflection model, both of its sides
/// alike. `normal` and `toEye` are unit vectors.
/// Source: Phong, "Illumination for computer generated pictures", Comm. ACM 18 (1975).
PALPATEVOLUMERENDERING_EXPORT Vector3 ShadedColor(const Vector3& color, const SurfaceFinish& finish,
                                                  const std::vector<SurfaceLight>& lights,
                                                  const Vector3& point, const Vector3& normal,
                                                  const Vector3& toEye) noexcept;
} // namespace palpate
