#pragma once

#include "Vector3.h"

#include <optional>

namespace palpate
{
/// One observation of an organ's surface.
struct SurfaceTouch
{
  Vector3 PointWorld = Vector3::Zero(); ///< mm
  double Deviation = 1.0;               ///< standard deviation along the surface's normal, mm
  /// Of the surface there, in the world's axes, of any length but 0 and either side.
  std::optional<Vector3> Normal = std::nullopt;
  /// Points of a stroke share an offset: a line drawn too wide is too wide everywhere. Points of
  /// the same number above 0 belong together.
  int Stroke = 0;
  bool IsOutside = false; ///< the surface does not reach as far as the point, which is not on it
};

inline bool operator==(const SurfaceTouch& a, const SurfaceTouch& b)
{
  return a.PointWorld == b.PointWorld && a.Deviation == b.Deviation && a.Normal == b.Normal &&
         a.Stroke == b.Stroke && a.IsOutside == b.IsOutside;
}
} // namespace palpate
