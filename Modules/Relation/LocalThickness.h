#pragma once

#include "IndexedMesh.h"

#include <vector>

namespace palpate
{
/// What the thickness at a point is.
enum class ThicknessRule
{
  Spheres, ///< the diameter of the largest ball that touches the surface there from inside
  Rays     ///< the length of the inward normal up to the opposite side
};

struct ThicknessSettings
{
  ThicknessRule Rule = ThicknessRule::Spheres;
  /// mm: how far a ball may stand out of the surface, so that its noise is not its shape. Rays have
  /// none.
  double Tolerance = 1e-4;
  /// How often normals are averaged with those of neighbouring points.
  int NormalSmoothing = 0;

  /// Of a surface that was made of voxels (columns: a step along each axis, mm). On round masks the
  /// median is then right to 0.25 voxel, half of the points are within 0.5 and nine tenths within
  /// 1.5 voxels; models have no such noise.
  static ThicknessSettings OfVoxels(const Matrix3& steps);
};

/// The thickness (mm) of a body at the points of its surface, which is oriented outwards and whose
/// triangles are small next to it; NaN at points without triangles. The surface may have holes
/// where nothing is known, as where an image cuts the body.
///
/// By spheres: the diameter of the largest ball that touches the surface there from inside and lies
/// in the body. Of a plate it is the distance of the faces, of a ball its diameter, at a tip the
/// least diameter of curvature. At most the body's least extent along an axis. That the ball
/// through p with the inward normal n may stand out by t, the tolerance, at q limits its radius to
/// (|q - p|^2 - t^2) / (2 ((q - p) . n - t)): the least over all points q, after Ma, Bae and Choi,
/// "3D medial axis point approximation using nearest neighbors and the normal field", Visual
/// Computer 28 (2012), who have t = 0.
///
/// By rays: the distance from the point along the one ray of the inward normal to where it leaves
/// the body, as the ray method in Inui, Umezu, Wakasaki and Sato, "Thickness and clearance
/// visualization based on distance field of 3D objects", J. Comput. Des. Eng. 2 (2015). It is at
/// least that by spheres, and depends on the side: of a wedge with the angle a it is tan(a) of the
/// distance to the edge. NaN where the ray finds no opposite side.
std::vector<double> LocalThicknessOf(const IndexedMesh& mesh, const ThicknessSettings& settings);
} // namespace palpate
