#pragma once

#include "Vector3.h"

#include <optional>

namespace palpate
{
/// One pull at a surface, or a push. Lengths mm, patient LPS.
struct SurfacePull
{
  Vector3 PlaceWorld = Vector3::Zero(); ///< the nearest point of the surface as it is now is pulled
  double Displacement = 0.0;            ///< along its direction, outwards
  /// Where that point goes instead. Of a radial model, whose points stay on their rays, the foot on
  /// the ray counts.
  std::optional<Vector3> TargetWorld;
  /// Standard deviations of the Gaussian displacement along the surface: of one, or the mean of
  /// two. With a second width of 0 there is one.
  double Width = 8.0;
  double SecondWidth = 0.0;
};

inline bool operator==(const SurfacePull& a, const SurfacePull& b)
{
  return a.PlaceWorld == b.PlaceWorld && a.Displacement == b.Displacement &&
         a.TargetWorld == b.TargetWorld && a.Width == b.Width && a.SecondWidth == b.SecondWidth;
}
} // namespace palpate
