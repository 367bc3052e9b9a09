#pragma once

#include "FieldMaterial.h"

namespace palpate
{
/// Corrects a node's distance (mm) to the removed volume so that trilinear interpolation between
/// nodes has its surface, on average, in the right place: where a distance is curved, interpolation
/// between its values lies above it by a twelfth of its second differences. `neighbours` are the
/// distances of the nodes before and after along each axis. On ridges between two cuts, where the
/// correction would be larger, the distance is unchanged.
template <typename T>
T InterpolatedDistance(T distance, const T (&neighbours)[6]) noexcept
{
  constexpr T Part = T(1) / T(12);
  T differences = T(-6) * distance;
  for (const T neighbour : neighbours)
  {
    differences += neighbour;
  }
  return distance - Part * (differences > T(0) ? differences : T(0));
}

/// Changes a node's value where a tool removes the inside of a condition. Near the tool the value
/// is at most a ramp through the iso-value at the tool's surface, with `Slope` per mm, so that the
/// remaining surface lies between voxels where the tool's was; farther than `depth` from it the
/// value is unchanged. A ramp ends at `Floor`, a value outside the material.
class NodeCut
{
public:
  /// `slope` > 0: the largest change of value per mm across a surface. `depth` > 0: extent (mm) of
  /// the ramp to either side of the surface.
  NodeCut(const FieldCondition& condition, double slope, double depth)
      : Iso(condition.Iso), Rise(condition.Sign() * slope), Depth(depth), Floor(Iso - Rise * depth),
        IsAtLeast(condition.Sense == FieldSense::AtLeast)
  {
  }

  /// `distance` (mm) to the tool, negative inside. No cut ever restores material.
  template <typename T>
  T Apply(T value, T distance) const noexcept
  {
    // Every branch is computed, so that loops over this vectorise.
    const auto depth = static_cast<T>(this->Depth);
    const T line = static_cast<T>(this->Iso) + static_cast<T>(this->Rise) * distance;
    const T ramp = distance < -depth ? static_cast<T>(this->Floor) : line;
    const T least = ramp < value ? ramp : value;
    const T most = ramp < value ? value : ramp;
    const T cut = this->IsAtLeast ? least : most;
    return distance > depth ? value : cut;
  }

private:
  double Iso;
  double Rise;  // per mm of distance, signed towards the inside of the material
  double Depth; // mm
  double Floor;
  bool IsAtLeast;
};
} // namespace palpate
