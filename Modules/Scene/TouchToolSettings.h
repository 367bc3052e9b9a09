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
    Drill, // a ball on a shaft
    Ellipsoid,
    Cylinder,
    Surface
  };
  Shape Kind = Shape::Sphere;
  double Radius = 2.0;      ///< mm; of sphere, capsule, cylinder and a drill's ball
  double Length = 10.0;     ///< mm, of a capsule's axis, of a drill's shaft, and of a cylinder
  double ShaftRadius = 1.0; ///< mm, of a drill; only the ball cuts, the shaft touches
  Vector3 SemiAxes = Vector3(4.0, 2.0, 2.0); ///< mm, of an ellipsoid
  std::filesystem::path File;                ///< of a closed surface, mm in the tool's frame
  /// Of a sphere's shell at fields; of a surface that touches, SurfacePoints if that is more.
  int Points = 26;
  static constexpr int SurfacePoints = 500;
  /// The content of File once it is read (see SurfaceOf); if null, it is read when the tool is
  /// needed.
  std::shared_ptr<const SurfaceTool> Surface = nullptr;
};

inline bool operator==(const TouchToolSettings& a, const TouchToolSettings& b)
{
  return a.Kind == b.Kind && a.Radius == b.Radius && a.Length == b.Length &&
         a.ShaftRadius == b.ShaftRadius && a.SemiAxes == b.SemiAxes && a.File == b.File &&
         a.Points == b.Points && a.Surface == b.Surface;
}
} // namespace palpate
