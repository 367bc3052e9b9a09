#pragma once

#include <cstdint>

namespace palpate
{
/// On which side of the iso-value a condition holds; the iso-value itself belongs to it.
enum class FieldSense
{
  AtLeast,
  AtMost
};

/// Holds where a channel's value is at least (or at most) the iso-value.
struct FieldCondition
{
  int Channel = 0;
  double Iso = 0.0;
  FieldSense Sense = FieldSense::AtLeast;

  /// Factor of value - Iso that makes it positive where the condition holds.
  double Sign() const noexcept { return this->Sense == FieldSense::AtLeast ? 1.0 : -1.0; }
  /// Converts values to the condition's margin: negative where it does not hold.
  void Relate(double* values, int count) const noexcept
  {
    const double sign = this->Sign();
    for (int i = 0; i < count; ++i)
    {
      values[i] = sign * (values[i] - this->Iso);
    }
  }
};

/// One touchable object: the points where all its conditions, one or two, hold.
struct FieldMaterial
{
  static constexpr int MostConditions = 2;
  int ConditionCount = 1;
  FieldCondition Conditions[MostConditions];
};

/// A set of materials, bit m for material m.
using MaterialSet = std::uint32_t;
constexpr int MostMaterials = 32;
constexpr MaterialSet AllMaterials = ~MaterialSet{0};

constexpr MaterialSet OnlyMaterial(int material) noexcept
{
  return MaterialSet{1} << material;
}
constexpr bool Contains(MaterialSet set, int material) noexcept
{
  return (set >> material & 1u) != 0;
}
} // namespace palpate
