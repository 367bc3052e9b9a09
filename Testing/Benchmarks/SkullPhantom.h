#pragma once

#include "FieldGrid.h"
#include "ScalarField.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace palpate::bench
{
/// A CT-like head: air, soft tissue with noise, and a closed shell of bone with a smooth profile, 4
/// to 5 mm thick.
struct SkullPhantom
{
  static constexpr double BoneIso = 400.0;

  FieldGrid Grid; ///< 0.8 mm
  std::vector<std::int16_t> Samples;
  Vector3 CenterWorld;

  explicit SkullPhantom(int nodes);

  /// The bone as a field. Throws std::runtime_error if it cannot be made.
  std::shared_ptr<const ScalarField> MakeField(FieldInterpolation interpolation) const;

  /// Half axes of the mid-surface of the bone, mm.
  Vector3 HalfAxes() const;
  /// The point on that mid-surface in a direction.
  Vector3 PointInBoneWorld(const Vector3& direction) const;
};
} // namespace palpate::bench
