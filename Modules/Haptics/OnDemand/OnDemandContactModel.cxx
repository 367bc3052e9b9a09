#include "OnDemandContactModel.h"

#include "FieldContactModel.h"
#include "FrictionCone.h"
#include "OnDemandTracker.h"

namespace palpate
{
Eigen::AlignedBox3d OnDemandContactModel::BoundsWorld() const noexcept
{
  return this->Field->BoundsWorld();
}

std::size_t OnDemandContactModel::Bytes() const noexcept
{
  return this->Field->Bytes();
}

Status OnDemandContactModel::MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                                         std::unique_ptr<ContactTracker>& tracker) const
{
  for (Status status : {tool.Check(), FrictionCone::Check(friction)})
  {
    if (!status.IsOk())
    {
      return status;
    }
  }
  const ToolShape shell = FieldContactModel::ShellFor(tool, this->Field->Newest()->VoxelSize());
  tracker = std::make_unique<OnDemandTracker>(this->Field, shell, friction);
  return Status::Success();
}
} // namespace palpate
