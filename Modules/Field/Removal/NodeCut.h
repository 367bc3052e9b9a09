#pragma once

#include "FieldMaterial.h"

namespace palpate
{
/// What a node's distance (mm) to all that was removed is to count as, so that trilinear
/// interpolation between nodes has the surface where it is, in the mean: where a distance is
/// curved, interpolation between its values lies above it by a twelfth of its second differences.
/// `neighbours` are the distances of the nodes before and after along each axis. On ridges between
/// two cuts, where it would be more, the distance is left as it is.
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

/// How a node's value changes where a tool removes what a condition holds inside. Near the tool the
/// value is at most a ramp through the iso-value at the tool's surface, `Slope` a millimetre steep,
/// so that the surface that remains lies between voxels where the tool's was; farther than `depth`
/// from it the value is left as it is. A ramp ends at `Floor`, a value that the material does not
/// have.
class NodeCut
{
public:
  /// `slope` > 0; by how much a value at most changes a millimetre on the way through a surface.
  /// `depth` > 0: how far (mm) from the surface the ramp goes on to either side.
  NodeCut(const FieldCondition& condition, double slope, double depth);

  /// `distance` (mm) to the tool, negative inside. No cut ever puts material back.
  template <typename T>
  T Apply(T value, T distance) const noexcept
  {
    // Every part is computed, so that loops over this go through the lanes of vectors.
    const auto depth = static_cast<T>(this->Depth);
    const T line = static_cast<T>(this->Iso) + static_cast<T>(this->Rise) * distance;
    const T ramp = distance < -depth ? static_cast<T>(this->Floor) : line;
    const T least = ramp < value ? ramp : value;
    const T most = ramp < value ? value : ramp;
    const T cut = this->IsAtLeast ? least : most;
    return distance > depth ? value : cut;
  }
  double DepthWorld() const noexcept { return this->Depth; } ///< mm
  double FloorValue() const noexcept { return this->Floor; }

private:
  double Iso;
  double Rise;  // a mm of distance, with the sign that leads into the material
  double Depth; // mm
  double Floor;
  bool IsAtLeast;
};
} // namespace palpate
