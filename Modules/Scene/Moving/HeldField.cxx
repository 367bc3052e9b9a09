#include "HeldField.h"

#include <utility>

namespace palpate
{
HeldField::HeldField(std::shared_ptr<const HeldFit> fit, const Eigen::Affine3d& pose,
                     const Vector3& toolWorld)
    : Fit(std::move(fit)), Pose(pose), Tool(toolWorld)
{
  Eigen::AlignedBox3d held;
  for (const Vector3& point : this->Fit->Points())
  {
    held.extend(pose * point);
  }
  const Vector3 reach = Vector3::Constant(this->Fit->Reach());
  const Eigen::AlignedBox3d& fixed = this->Fit->FixedBounds();
  this->Bounds = {toolWorld + fixed.min() - reach - held.max(),
                  toolWorld + fixed.max() + reach - held.min()};
}

Eigen::Affine3d HeldField::PoseAt(const Vector3& toolWorld) const noexcept
{
  Eigen::Affine3d pose = this->Pose;
  pose.pretranslate(toolWorld - this->Tool);
  return pose;
}

Vector3 HeldField::ForceWorld(const Vector3& originWorld) const noexcept
{
  return this->Fit->At(this->PoseAt(originWorld)).Force;
}
} // namespace palpate
