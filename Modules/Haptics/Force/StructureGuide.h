#pragma once

#include "ForceField.h"
#include "GuideLaw.h"
#include "StructureDistance.h"

#include <memory>

namespace palpate
{
/// Keeps the tool's origin inside, outside or at a level of the signed distance to a structure, by
/// the law of guides (GuideLaw) of the distance D from that level; so "outside" is a soft wall, and
/// "surface" a shell. The force is minus the gradient of the law's potential, continuous
/// everywhere, 0 farther than the range, and at most the largest force. Its energy is at most k
/// R^2 / 6. Where several parts of the surface are equally near, the gradient of the distance, and
/// so the force, passes through 0 (StructureDistance). Immutable, shared by threads.
class StructureGuide final : public ForceField
{
public:
  /// Fails for a guide without a structure (see CheckGuide), and for distances that do not reach as
  /// far as the guide.
  static Status Make(const GuideSettings& settings,
                     std::shared_ptr<const StructureDistance> distance,
                     std::shared_ptr<const StructureGuide>& made);

  Vector3 ForceWorld(const Vector3& originWorld) const noexcept override;
  Eigen::AlignedBox3d BoundsWorld() const noexcept override { return this->Field->BoundsWorld(); }
  double Stiffness() const noexcept override;
  /// N mm, of the tool's origin at a place; from -Energy() at the guide to 0.
  double PotentialAt(const Vector3& originWorld) const noexcept;
  double Energy() const noexcept { return this->Law.Energy(); } ///< N mm

private:
  StructureGuide(const GuideSettings& settings, std::shared_ptr<const StructureDistance> distance);
  // mm beyond the level; 0 on the side where the tool may be.
  double Beyond(double distance) const noexcept;

  std::shared_ptr<const StructureDistance> Field;
  GuideShape Shape;
  double Level; // mm
  GuideLaw Law;
};
} // namespace palpate
