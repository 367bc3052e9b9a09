#pragma once

#include "Vector3.h"

#include <filesystem>
#include <memory>

namespace palpate
{
class SurfaceTool;

/// The tool of a scene.
struct TouchToolSettings
{
  enum class Shape
  {
    Sphere,
    Capsule,
    Ellipsoid,
    Cylinder,
    Surface
  };
  Shape Kind = Shape::Sphere;
  double Radius = 2.0;                       ///< mm; of sphere, capsule and cylinder
  double Length = 10.0;                      ///< mm, of a capsule's axis, and of a cylinder
  Vector3 SemiAxes = Vector3(4.0, 2.0, 2.0); ///< mm, of an ellipsoid
  std::filesystem::path File;                ///< of a closed surface, mm in the tool's frame
  int Points = 26;                           ///< of the shell that touches fields
  /// The content of File once it is read (see SurfaceOf); if null, it is read when the tool is
  /// needed.
  std::shared_ptr<const SurfaceTool> Surface = nullptr;
};

inline bool operator==(const TouchToolSettings& a, const TouchToolSettings& b)
{
  return a.Kind == b.Kind && a.Radius == b.Radius && a.Length == b.Length &&
         a.SemiAxes == b.SemiAxes && a.File == b.File && a.Points == b.Points &&
         a.Surface == b.Surface;
}
} // namespace palpate
