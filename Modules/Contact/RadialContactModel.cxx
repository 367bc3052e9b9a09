#include "RadialContactModel.h"

#include "FrictionCone.h"
#include "NearestPointTracker.h"
#include "RadialTracker.h"
#include "TouchableRadialModel.h"

#include <utility>

namespace palpate
{
Status RadialContactModel::Make(std::shared_ptr<const RadialModel> model, RadialContactMode mode,
                                std::shared_ptr<const ContactModel>& contact)
{
  std::shared_ptr<const TouchableRadialModel> surface;
  Status status = TouchableRadialModel::Make(std::move(model), surface);
  if (status.IsOk())
  {
    contact.reset(new RadialContactModel(std::move(surface), mode));
  }
  return status;
}

RadialContactModel::RadialContactModel(std::shared_ptr<const TouchableRadialModel> surface,
                                       RadialContactMode mode)
    : Surface(std::move(surface)), Mode(mode)
{
}

Eigen::AlignedBox3d RadialContactModel::BoundsWorld() const noexcept
{
  return this->Surface->BoundsWorld();
}

std::size_t RadialContactModel::Bytes() const noexcept
{
  return this->Surface->Bytes();
}

Status RadialContactModel::MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
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
  if (this->Mode == RadialContactMode::Nearest)
  {
    tracker = std::make_unique<NearestPointTracker>(this->Surface, tool.Radius(), friction);
    return Status::Success();
  }
  if (friction.Static > 0.0)
  {
    return Status::Failure("The radial method has no friction.");
  }
  tracker = std::make_unique<RadialTracker>(this->Surface, tool.Radius());
  return Status::Success();
}
} // namespace palpate
