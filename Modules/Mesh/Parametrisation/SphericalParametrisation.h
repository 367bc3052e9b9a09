#pragma once

#include "KernelProgress.h"
#include "SphereMapQuality.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// A surface laid out on the unit sphere, one to one.
struct SphericalParametrisation
{
  std::vector<Vector3> Directions; ///< unit vectors, one per point of the surface
  SphereMapQuality Quality;        ///< a policy refuses a surface that is too distorted
};

/// Maps a closed surface of genus 0 to the sphere with little distortion of area and angles, every
/// triangle positively oriented.
///
/// Progressive mesh (Praun and Hoppe 2003): half-edge collapses take the surface down to a
/// tetrahedron, the vertices return in reverse order into the kernels of their rings, and sweeps of
/// Newton steps (VertexRelaxation) lower the energy at growing numbers of vertices. No step may
/// turn a triangle over, and the result is verified. It depends on edge lengths only: a copy that
/// is rotated, moved or scaled has the same map, up to rounding that the sweeps amplify to some
/// 1e-6; a mirrored copy has the mirrored map. How the map lies on the sphere is arbitrary: see
/// SphericalPlacement.
///
/// Fails, with a message, if `surface` is not one closed, oriented manifold without handles, if it
/// has a point that is not finite or a triangle without area, if the map degenerates beyond
/// double precision or if `progress`, which may be empty, cancels. Deterministic. Time
/// O(n log n), some 6 us a triangle; memory some 300 bytes a triangle.
Status ParametriseOnSphere(const IndexedMesh& surface, const KernelProgress& progress,
                           SphericalParametrisation& result);
} // namespace palpate
