#pragma once

#include "Vector3.h"

namespace palpate
{
/// A triangle by its corners.
struct Facet
{
  Vector3 A;
  Vector3 B;
  Vector3 C;
};

/// A sphere on its way.
struct SphereMotion
{
  Vector3 Start; ///< of its centre
  Vector3 Way;
  double Radius;
};

struct SweepHit
{
  double Part = 1.0;                 ///< of the way, 0 to 1
  Vector3 Normal = Vector3::UnitZ(); ///< unit vector from the touched place to the centre
  double Overlap = 0.0;              ///< how deep the sphere was in already, if it touches at once
  bool IsHit = false;
};

/// The point of a facet nearest to a point (Ericson, Real-Time Collision Detection, 2005, ch. 5).
Vector3 ClosestPointOnFacet(const Vector3& point, const Facet& facet) noexcept;

/// Makes `hit` the first touch of the sphere with the facet if that is earlier than what `hit`
/// holds. A sphere that already touches is hit at once if it comes nearer, and else not at all.
/// Faces touch from both sides; edges are cylinders and corners spheres round them.
void SweepSphere(const SphereMotion& motion, const Facet& facet, SweepHit& hit) noexcept;
} // namespace palpate
