#pragma once

#include "ForceField.h"
#include "HeldFit.h"
#include "PalpateSceneModule.h"

#include <memory>

namespace palpate
{
/// What a device's hand feels that holds an organ: the organ moves as the tool does, without
/// turning, and its fit to another surface gives the force (HeldFit). Immutable.
class PALPATESCENE_EXPORT HeldField final : public ForceField
{
public:
  /// `pose` is the organ's where the tool is at `toolWorld` (mm).
  HeldField(std::shared_ptr<const HeldFit> fit, const Eigen::Affine3d& pose,
            const Vector3& toolWorld);

  /// With the tool there.
  Eigen::Affine3d PoseAt(const Vector3& toolWorld) const noexcept;
  /// Where the tool is if the organ, unturned, is there.
  Vector3 ToolOf(const Eigen::Affine3d& pose) const noexcept
  {
    return this->Tool + pose.translation() - this->Pose.translation();
  }
  Vector3 ForceWorld(const Vector3& originWorld) const noexcept override;
  Eigen::AlignedBox3d BoundsWorld() const noexcept override { return this->Bounds; }
  double Stiffness() const noexcept override { return this->Fit->Stiffness(); }

private:
  std::shared_ptr<const HeldFit> Fit;
  Eigen::Affine3d Pose;
  Vector3 Tool;
  Eigen::AlignedBox3d Bounds;
};
} // namespace palpate
