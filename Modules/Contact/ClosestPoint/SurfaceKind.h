#pragma once

#include "CenteredSurface.h"
#include "PointDerivativeBounds.h"
#include "RadialModel.h"
#include "RadiusDerivativeBounds.h"
#include "RoundBasin.h"
#include "StretchedBasin.h"
#include "SurfaceBox.h"
#include "SurfacePatch.h"

#include <cstddef>

namespace palpate
{
/// What closest-point searches need to know about a kind of surface at compile time. Everything
/// else about it is in functions that are overloaded for its samples.
template <typename Surface>
struct SurfaceKind;

template <>
struct SurfaceKind<RadialModel>
{
  using Bounds = RadiusDerivativeBounds;
  using Patch = SurfacePatch;
  using Basin = RoundBasin;
  /// Angle (rad) that a tracked point may be off its minimum; the distance is then off by the
  /// square of it, far below rounding.
  static constexpr double TrackingTolerance = 1e-7;
  /// Parts of a SurfacePatchTree in the finest detail that the degree can represent.
  static constexpr int PartFraction = 1;
  /// Memory of a ClearanceProof.
  static constexpr std::size_t ProofCells = 1280;
  /// A proof's evaluation, with the bounds that it leads to, another bound of an evaluated part,
  /// and bounds of four nodes at once take as long as this many bounds of nodes.
  static constexpr int WorkOfEvaluation = 16;
  static constexpr int WorkOfBound = 4;
  static constexpr int WorkOfGroup = 2;
};

template <>
struct SurfaceKind<CenteredSurface>
{
  using Bounds = PointDerivativeBounds;
  using Patch = SurfaceBox;
  using Basin = StretchedBasin;
  /// The point itself is then exact to some 1e-9 mm.
  static constexpr double TrackingTolerance = 1e-10;
  static constexpr int PartFraction = 2;
  static constexpr std::size_t ProofCells = 3072;
  static constexpr int WorkOfEvaluation = 6;
  static constexpr int WorkOfBound = 2;
  static constexpr int WorkOfGroup = 1;
};

template <typename Surface>
using SampleOf = typename Surface::SecondOrderSample;
} // namespace palpate
