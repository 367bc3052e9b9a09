#pragma once

#include "FieldMaterial.h"

namespace palpate
{
/// What a node's distance (mm) to all that was removed is to count as, so that trilinear
/// interpolation between nodes has the surface where it is, in the mean: where a distance is
/// curved, interpolation between its values lies above it by a twelfth of its second differences.
/// `neighbours` are the distances of the nodes before and after along each axis. On ridges between
/// two cuts, where it would be more, the distance is left as it is.
inline double InterpolatedDistance(double distance, const double (&neighbours)[6]) noexcept
{
  constexpr double Part = 1.0 / 12.0;
  double differences = -6.0 * distance;
  for (const double neighbour : neighbours)
  {
    differences += neighbour;
  }
  return differences > 0.0 ? distance - Part * differences : distance;
}

/// How a node's value changes where a tool removes what a condition holds inside. Near the tool the
/// value is at most a ramp through the iso-value at the tool's surface, `Slope` a millimetre steep,
/// so that the surface that remains lies between voxels where the tool's was; away from it the
/// value is left as it is. A ramp ends at `Floor`, a value that the material does not have.
class NodeCut
{
public:
  /// `slope` > 0; by how much a value at most changes a millimetre on the way through a surface.
  /// `depth` > 0: how far (mm) from the surface the ramp goes on inside the tool.
  NodeCut(const FieldCondition& condition, double slope, double depth);

  /// `distance` (mm) to the tool, negative inside. No cut ever puts material back.
  double Apply(double value, double distance) const noexcept
  {
    const double ramp = distance < -this->Depth ? this->Floor : this->Iso + this->Rise * distance;
    return this->IsAtLeast ? (ramp < value ? ramp : value) : (ramp > value ? ramp : value);
  }
  double FloorValue() const noexcept { return this->Floor; }

private:
  double Iso;
  double Rise;  // a mm of distance, with the sign that leads into the material
  double Depth; // mm
  double Floor;
  bool IsAtLeast;
};
} // namespace palpate
