#pragma once

#include "SphericalHarmonicModel.h"
#include "SphericalHarmonicSpectrum.h"
#include "SphericalTriangle.h"
#include "Vector3.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// Certified bounds of a model's radius and of its slope over cones of directions: for broad phases
/// and step limits. Built once per model; queries are const, thread-safe and allocation-free.
///
/// The sphere is split into the icosahedron's faces, and these recursively into four, `Depth`
/// times. Each triangle stores an enclosing cap and an interval that holds every radius in it. A
/// query descends where a cap crosses the cone's boundary, unites the intervals of the caps inside
/// or at the boundary, and intersects the result with Taylor's formula from one evaluation at the
/// axis. Bounds are never too narrow, including rounding; they are too wide by the change of the
/// radius over a smallest triangle at the boundary, and by the slack of the intervals.
class SphericalHarmonicBounds
{
public:
  struct Options
  {
    /// Smallest triangles: 20 * 4^Depth of them, some 37 / 2^Depth degrees from centre to corner;
    /// 48 bytes each, and a third more for the larger ones.
    int Depth = 3;
    /// Each smallest triangle's interval is computed from 4^Refinement parts: the slack falls as
    /// 4^-(Depth + Refinement). Building takes 20 * 4^(Depth + Refinement) evaluations.
    int Refinement = 2;
  };

  /// Depth and refinement below 0 count as 0. Keeps a copy of the model.
  explicit SphericalHarmonicBounds(const SphericalHarmonicModel& model)
      : SphericalHarmonicBounds(model, Options())
  {
  }
  SphericalHarmonicBounds(const SphericalHarmonicModel& model, const Options& options);

  const SphericalHarmonicModel& Model() const noexcept { return this->Surface; }
  const SphericalHarmonicSpectrum& Spectrum() const noexcept { return this->Powers; }

  /// Over all directions. FindRadiusRange gives a narrower interval.
  const RadiusInterval& Radius() const noexcept { return this->Whole; }
  /// Upper bound of the surface gradient over all directions (mm/rad).
  double Slope() const noexcept { return this->WholeSlope; }

  /// Encloses every radius (mm) within `halfAngle` (rad) of the unit vector `axis`. Up to a
  /// smallest triangle's size it takes one evaluation, above also a traversal of some nanoseconds
  /// per triangle at the boundary. Negative angles count as 0, above pi and NaN as the whole
  /// sphere.
  RadiusInterval RadiusInCone(const Vector3& axis, double halfAngle) const noexcept;
  /// Upper bound of the surface gradient in that cone (mm/rad).
  double SlopeInCone(const Vector3& axis, double halfAngle) const noexcept;

private:
  // Triangles in depth-first order: each is followed by its parts. Geometry is in float; the
  // radius of a cap includes its rounding.
  struct Node
  {
    float Center[3];
    float HalfSine; // of half the cap's radius
    float HalfCosine;
    std::int32_t Next; // the first node that is not part of this one
    RadiusInterval Interval;
    double Slope;
  };
  struct Cone;

  std::int32_t Build(const SphericalTriangle& triangle, int depth, int refinement);
  void Enclose(const SphericalTriangle& triangle, int refinement, Node& node) const;
  template <typename AddsNothing, typename Join>
  void Walk(const Cone& cone, AddsNothing addsNothing, Join join) const noexcept;

  SphericalHarmonicModel Surface;
  SphericalHarmonicSpectrum Powers;
  std::vector<Node> Nodes;
  RadiusInterval Whole{};
  double WholeSlope = 0.0;
  double WalkFrom = 0.0; // rad; Taylor's formula is at least as good for narrower cones
};
} // namespace palpate
