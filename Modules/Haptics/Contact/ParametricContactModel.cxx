#include "ParametricContactModel.h"

#include "FrictionCone.h"
#include "HarmonicNearestTracker.h"

#include <utility>

namespace palpate
{
Status ParametricContactModel::Make(const ParametricSphericalSurface& surface,
                                    std::shared_ptr<const ContactModel>& contact)
{
  std::shared_ptr<const ParametricTouchSurface> touch;
  Status status = ParametricTouchSurface::Make(surface, touch);
  if (status.IsOk())
  {
    contact.reset(new ParametricContactModel(std::move(touch)));
  }
  return status;
}

ParametricContactModel::ParametricContactModel(
    std::shared_ptr<const ParametricTouchSurface> surface)
    : Surface(std::move(surface))
{
}

Eigen::AlignedBox3d ParametricContactModel::BoundsWorld() const noexcept
{
  const Vector3& center = this->Surface->Model().CenterWorld();
  const Vector3 reach = Vector3::Constant(this->Surface->LargestRadius());
  return {center - reach, center + reach};
}

std::size_t ParametricContactModel::Bytes() const noexcept
{
  return this->Surface->Bytes();
}

Status ParametricContactModel::MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
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
  tracker = std::make_unique<ParametricNearestTracker>(this->Surface, tool.Radius(), friction);
  return Status::Success();
}
} // namespace palpate
