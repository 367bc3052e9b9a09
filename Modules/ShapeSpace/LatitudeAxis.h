#pragma once

#include "SurfaceModel.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// The axis of a surface through the middles of the circles of equal latitude about the parameters'
/// x axis, which SPHARM-PDM calls the medial axis (Xu's SphericalHarmonicMedialAxisMeshSource): at
/// `Theta` (rad from +x) the mean of the surface points along the circle, their mean distance from
/// it, and the area of the fan of triangles between it and them. The points are the surface of the
/// parameters (cos theta, sin theta sin phi, -sin theta cos phi), circle by circle; the last of a
/// circle (phi = 2 pi) is the first again, and counts once.
struct LatitudeAxis
{
  int Longitudes = 0; ///< points of a circle
  std::vector<double> Theta;
  std::vector<Vector3> Middles; ///< mm, in the surface's frame
  std::vector<double> Radii;    ///< mm
  std::vector<double> Areas;    ///< mm^2
  ///@{ Of each point: its place and distance from the middle, mm, and the area of the triangle from
  /// the middle to it and the next one, mm^2.
  std::vector<Vector3> Points;
  std::vector<double> PartialRadii;
  std::vector<double> PartialAreas;
  ///@}
};

/// `latitudes` >= 2 from pole to pole, `longitudes` >= 4 points on each. Allocates.
LatitudeAxis FindLatitudeAxis(const SurfaceModel& surface, int latitudes, int longitudes);

/// The same surface with its parameters turned, so that their x axis points along the longest axis
/// of its ellipsoid of degree 1 and z along the shortest, as SPHARM-PDM's do; which of two opposite
/// directions is that of PlaceByEllipsoid. Unchanged if it has no such axes. Allocates.
SurfaceModel WithLongAxisFirst(const SurfaceModel& surface);
} // namespace palpate
