#pragma once

#include "SurfaceEvaluator.h"
#include "SurfaceModel.h"
#include "Vector3.h"

#include <cstddef>

namespace palpate
{
/// A surface model as searches for closest points need it: points relative to the surface's
/// centre, with the derivatives along the unit sphere of parameters. Immutable; queries are const,
/// thread-safe and allocation-free.
class CenteredSurface
{
public:
  /// mm, mm/rad, mm/rad^2; points are relative to the centre.
  using SecondOrderSample = SurfaceEvaluator::SecondOrderSample;

  explicit CenteredSurface(const SurfaceModel& surface);

  int Degree() const noexcept { return this->MaximumDegree; }
  /// The mean of the surface over the parameters, mm.
  const Vector3& CenterWorld() const noexcept { return this->Center; }
  /// The tables that queries read.
  std::size_t Bytes() const noexcept { return sizeof(*this) + this->Evaluator.TableBytes(); }

  /// For a unit vector of parameters.
  SecondOrderSample EvaluateSecondOrder(const Vector3& parameter) const noexcept
  {
    return this->Evaluator.EvaluateSecondOrder(parameter);
  }
  /// mm.
  Vector3 PointWorld(const Vector3& parameter) const noexcept
  {
    return this->Center + this->Evaluator.Point(parameter);
  }

private:
  SurfaceEvaluator Evaluator; // without the means
  Vector3 Center;
  int MaximumDegree;
};
} // namespace palpate
