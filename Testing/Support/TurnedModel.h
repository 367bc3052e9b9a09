#pragma once

#include "RadialModel.h"
#include "SphericalHarmonicProjection.h"

namespace palpate::test
{
/// The model rotated about a point of the world (mm).
inline RadialModel TurnedModel(const RadialModel& model, const Matrix3& turn,
                               const Vector3& pivotWorld)
{
  const auto radius = [&](const Vector3& u) { return model.Radius(turn.transpose() * u); };
  return {model.Degree(), ProjectOnHarmonics(model.Degree(), 2 * model.Degree(), radius),
          pivotWorld + turn * (model.CenterWorld() - pivotWorld)};
}
} // namespace palpate::test
