#include "HarmonicContactModel.h"

#include "FrictionCone.h"
#include "HarmonicNearestTracker.h"
#include "HarmonicRadialTracker.h"

#include <utility>

namespace palpate
{
Status HarmonicContactModel::Make(std::shared_ptr<const SphericalHarmonicModel> model,
                                  HarmonicContactMode mode,
                                  std::shared_ptr<const ContactModel>& contact)
{
  std::shared_ptr<const HarmonicSurface> surface;
  Status status = HarmonicSurface::Make(std::move(model), surface);
  if (status.IsOk())
  {
    contact.reset(new HarmonicContactModel(std::move(surface), mode));
  }
  return status;
}

HarmonicContactModel::HarmonicContactModel(std::shared_ptr<const HarmonicSurface> surface,
                                           HarmonicContactMode mode)
    : Surface(std::move(surface)), Mode(mode)
{
}

std::size_t HarmonicContactModel::Bytes() const noexcept
{
  return this->Surface->Bytes();
}

Status HarmonicContactModel::MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
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
  if (this->Mode == HarmonicContactMode::Nearest)
  {
    tracker = std::make_unique<HarmonicNearestTracker>(this->Surface, tool.Radius(), friction);
    return Status::Success();
  }
  if (friction.Static > 0.0)
  {
    return Status::Failure("The radial method has no friction.");
  }
  tracker = std::make_unique<HarmonicRadialTracker>(this->Surface, tool.Radius());
  return Status::Success();
}
} // namespace palpate
