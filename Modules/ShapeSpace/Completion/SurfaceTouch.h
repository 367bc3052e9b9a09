#pragma once

#include "Status.h"
#include "Vector3.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace palpate
{
/// One observation of an organ's surface.
struct SurfaceTouch
{
  static constexpr std::size_t Most = 1000;      ///< of one organ
  static constexpr double StrokeDeviation = 0.5; ///< of the offset of a stroke, mm

  Vector3 PointWorld = Vector3::Zero(); ///< mm
  double Deviation = 1.0;               ///< standard deviation along the surface's normal, mm
  /// Of the surface there, in the world's axes, of any length but 0: outward for
  /// SurfaceCompletion, of either side for ShapeCompletion.
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

/// Fails for more than SurfaceTouch::Most, numbers that are not finite, standard deviations outside
/// of 0.01 to 100 mm, points more than 1,000 mm from the centre, and normals of length 0.
Status CheckTouches(const std::vector<SurfaceTouch>& touches, const Vector3& centerWorld);
/// The middle of the box of the points on the surface; none if there are none.
std::optional<Vector3> MiddleOf(const std::vector<SurfaceTouch>& touches);
/// The RMS distance (mm) of the points from their surface that their noise makes likely.
double ExpectedDistance(const std::vector<SurfaceTouch>& touches) noexcept;
} // namespace palpate
