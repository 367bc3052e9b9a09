#pragma once

#include "SphereFlow.h"
#include "SurfaceModel.h"

namespace palpate
{
/// A surface with other parameters, and what that changed.
struct ReparametrisedSurface
{
  SurfaceModel Surface{0, {{{0.0}, {0.0}, {0.0}}}};
  bool IsOneToOne = false;     ///< every triangle of the samples is positively oriented
  double RmsTurn = 0.0;        ///< of the parameters over the sphere, rad
  double LeastAreaRatio = 1.0; ///< of areas on the parameter sphere, after over before
  double RmsChange = 0.0;      ///< distance from the given surface, weighted by area, mm
  double LargestChange = 0.0;  ///< mm
};

/// The surface u -> X(flow(u)) in the degree of X. It is fitted along the normals of X to samples
/// as dense as an icosahedron of twice that frequency, since sliding within the surface does not
/// change it; the distance of the result is that of its samples from their nearest points of X near
/// the same parameters. Allocates.
ReparametrisedSurface Reparametrise(const SurfaceModel& surface, const SphereFlow& flow);
} // namespace palpate
