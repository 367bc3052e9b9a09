#pragma once

#include "ForceField.h"
#include "GuideLaw.h"

#include <memory>
#include <vector>

namespace palpate
{
/// Pulls the tool's origin towards the nearest point of a guide, by the law of guides (GuideLaw).
/// Since the distance is continuous, so is the potential, and closed paths do no work; where two
/// parts of a path are equally near, the force turns from the one to the other in a step.
/// Immutable, shared by threads.
class GuideField final : public ForceField
{
public:
  /// Fails as CheckGuide does, and for a guide by a structure.
  static Status Make(const GuideSettings& settings, std::shared_ptr<const ForceField>& made);

  Vector3 ForceWorld(const Vector3& originWorld) const noexcept override;
  Eigen::AlignedBox3d BoundsWorld() const noexcept override;
  double Stiffness() const noexcept override { return this->Law.Stiffness(); }

private:
  explicit GuideField(const GuideSettings& settings);
  Vector3 NearestTo(const Vector3& originWorld) const noexcept;

  GuideShape Shape;
  std::vector<Vector3> Points; // mm
  Vector3 Normal = Vector3::UnitZ();
  GuideLaw Law;
};
} // namespace palpate
