#pragma once

#include "ParametricShape.h"
#include "PointDerivativeBounds.h"
#include "RadiusDerivativeBounds.h"
#include "SphericalHarmonicModel.h"
#include "SurfaceBox.h"
#include "SurfacePatch.h"

namespace palpate
{
/// What closest-point searches need to know about a kind of surface at compile time. Everything
/// else about it is in functions that are overloaded for its samples.
template <typename Surface>
struct SurfaceKind;

template <>
struct SurfaceKind<SphericalHarmonicModel>
{
  using Bounds = RadiusDerivativeBounds;
  using Patch = SurfacePatch;
  /// Angle (rad) that a tracked point may be off its minimum; the distance is then off by the
  /// square of it, far below rounding.
  static constexpr double TrackingTolerance = 1e-7;
};

template <>
struct SurfaceKind<ParametricShape>
{
  using Bounds = PointDerivativeBounds;
  using Patch = SurfaceBox;
  /// The point itself is then exact to some 1e-9 mm.
  static constexpr double TrackingTolerance = 1e-10;
};

template <typename Surface>
using SampleOf = typename Surface::SecondOrderSample;
} // namespace palpate
