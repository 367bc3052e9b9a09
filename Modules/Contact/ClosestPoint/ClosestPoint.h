#pragma once

#include "RadialModel.h"
#include "SquaredDistance.h"
#include "SurfaceKind.h"
#include "Vector3.h"

namespace palpate
{
/// The point of a surface closest to a query, with its error bounds.
template <typename Surface>
struct ClosestPointOf
{
  enum class Outcome
  {
    Minimum,    ///< a strict minimum of the distance, within PositionError
    Stationary, ///< not a strict minimum: a saddle, or points equally close all around, as in the
                ///< centre of a sphere
    Limit,      ///< the evaluation limit was reached
    BadInput    ///< the query or the surface is not finite; the other members are meaningless
  };

  Vector3 Direction;     ///< unit vector from a model's centre, or the parameter
  Vector3 PointWorld;    ///< mm
  Vector3 Normal;        ///< outward unit normal there; the direction if the surface has none
  double SignedDistance; ///< from the point to the query, mm; negative inside
  /// The distance is at most this much (mm) longer than the minimum: of the whole surface for a
  /// global search, else of the tracked minimum (infinite if there is none).
  double DistanceError;
  /// Largest distance (mm) of the exact minimum from PointWorld; infinite if unknown.
  double PositionError;
  int Evaluations = 0; ///< of the surface with its first two derivatives
  Outcome State = Outcome::BadInput;

  /// The last evaluated sample, very close to Direction, and the expansion of the distance there:
  /// tracking continues from it, which saves one evaluation.
  Vector3 SampleDirection;
  SampleOf<Surface> Sample;
  SquaredDistance Expansion;

  bool Converged() const noexcept { return this->State == Outcome::Minimum; }
};
using ClosestPoint = ClosestPointOf<RadialModel>;
} // namespace palpate
