#pragma once

#include "SphericalHarmonicModel.h"
#include "SquaredDistance.h"
#include "Vector3.h"

namespace palpate
{
/// The point of a model's surface nearest to a query, and how well it is known.
struct ClosestPoint
{
  enum class Outcome
  {
    Minimum,    ///< a strict minimum of the distance, within PositionError
    Stationary, ///< no strict minimum: a saddle, or points equally near all around, as in the
                ///< centre of a sphere
    Limit,      ///< the evaluations allowed did not suffice
    BadInput    ///< the query or the surface is not finite; the numbers mean nothing
  };

  Vector3 Direction;     ///< unit vector from the model's centre
  Vector3 PointWorld;    ///< centre + R u, mm
  Vector3 Normal;        ///< outward unit normal there; the direction where the surface has none
  double SignedDistance; ///< from the point to the query, mm; negative inside
  /// The distance is at most this much (mm) longer than the minimum: of the whole surface if a
  /// global search made this, else of the minimum that was tracked (infinite if there is none).
  double DistanceError;
  /// How far (mm) the exact minimum may be from PointWorld; infinite if that is not known.
  double PositionError;
  int Evaluations = 0; ///< of the radius with its first two derivatives
  Outcome State = Outcome::BadInput;

  /// The surface as it was last evaluated, very close to Direction, and the distance expanded
  /// there: where tracking goes on, which spares it one evaluation.
  Vector3 SampleDirection;
  SphericalHarmonicModel::SecondOrderSample Sample;
  SquaredDistance Expansion;

  bool Converged() const noexcept { return this->State == Outcome::Minimum; }
};
} // namespace palpate
