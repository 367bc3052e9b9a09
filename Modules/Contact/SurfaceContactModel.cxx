#include "SurfaceContactModel.h"

#include "FrictionCone.h"
#include "NearestPointTracker.h"
#include "TouchableSurfaceModel.h"

#include <utility>

namespace palpate
{
Status SurfaceContactModel::Make(const SurfaceModel& surface,
                                 std::shared_ptr<const ContactModel>& contact)
{
  std::shared_ptr<const TouchableSurfaceModel> touch;
  Status status = TouchableSurfaceModel::Make(surface, touch);
  if (status.IsOk())
  {
    contact.reset(new SurfaceContactModel(std::move(touch)));
  }
  return status;
}

SurfaceContactModel::SurfaceContactModel(std::shared_ptr<const TouchableSurfaceModel> surface)
    : Surface(std::move(surface))
{
}

Eigen::AlignedBox3d SurfaceContactModel::BoundsWorld() const noexcept
{
  const Vector3& center = this->Surface->Model().CenterWorld();
  const Vector3 reach = Vector3::Constant(this->Surface->LargestRadius());
  return {center - reach, center + reach};
}

std::size_t SurfaceContactModel::Bytes() const noexcept
{
  return this->Surface->Bytes();
}

Status SurfaceContactModel::MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                                        std::unique_ptr<ContactTracker>& tracker) const
{
  for (Status status : {tool.Check(), FrictionCone::Check(friction)})
  {
    if (!status.IsOk())
    {
      return status;
    }
  }
  if (!tool.IsSphere())
  {
    return Status::Failure("Spherical-harmonic surfaces support spherical and point tools only.");
  }
  tracker = std::make_unique<SurfaceTracker>(this->Surface, tool.Radius(), friction);
  return Status::Success();
}
} // namespace palpate
