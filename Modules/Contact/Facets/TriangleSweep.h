#pragma once

#include "Vector3.h"

namespace palpate
{
/// A non-degenerate triangle, by its corners.
struct Facet
{
  Facet(const Vector3& a, const Vector3& b, const Vector3& c)
      : A(a), B(b), C(c), Normal((b - a).cross(c - a).normalized())
  {
  }

  Vector3 A;
  Vector3 B;
  Vector3 C;
  Vector3 Normal; ///< unit vector to the side from which the corners are counter-clockwise
};

/// A moving sphere.
struct SphereMotion
{
  Vector3 Start; ///< of its centre
  Vector3 Path;
  double Radius;
  /// A facet that the whole path enters by no more than this is not hit: noise of a mesh's
  /// coordinates must not hold a sphere that slides along it.
  double Slack = 0.0;
};

struct SweepHit
{
  double Part = 1.0;                 ///< of the path, 0 to 1
  Vector3 Normal = Vector3::UnitZ(); ///< unit vector from the touched place to the centre
  double Overlap = 0.0;              ///< initial depth, if the sphere already overlaps
  bool IsHit = false;
};

/// The point of a facet nearest to a point (Ericson, Real-Time Collision Detection, 2005, ch. 5).
Vector3 ClosestPointOnFacet(const Vector3& point, const Facet& facet) noexcept;

/// Sets `hit` to the first contact of the sphere with the facet if that is earlier than `hit`. A
/// sphere that already touches is hit at once if it approaches, and else not at all. Faces touch
/// from both sides; edges are cylinders and corners spheres around them.
void SweepSphere(const SphereMotion& motion, const Facet& facet, SweepHit& hit) noexcept;
} // namespace palpate
