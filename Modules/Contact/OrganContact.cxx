#include "OrganContact.h"

#include "FrictionCone.h"
#include "NearestPointTracker.h"
#include "OrganGaps.h"
#include "RadialTracker.h"
#include "TouchableRadialModel.h"
#include "TouchableSurfaceModel.h"

#include <utility>

namespace palpate
{
namespace
{
template <typename Touchable>
class OrganContact : public ContactModel
{
public:
  explicit OrganContact(std::shared_ptr<const Touchable> surface) : Surface(std::move(surface)) {}

  Eigen::AlignedBox3d BoundsWorld() const noexcept override
  {
    const Vector3& center = this->Surface->Model().CenterWorld();
    const Vector3 reach = Vector3::Constant(this->Surface->LargestRadius());
    return {center - reach, center + reach};
  }
  std::size_t Bytes() const noexcept override { return this->Surface->Bytes(); }

  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override
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
    return this->TrackerOf(tool.Radius(), friction, tracker);
  }

  Status MakeGaps(const ToolShape& tool, const SurfaceFriction& friction,
                  std::unique_ptr<ToolGaps>& gaps) const override
  {
    if (this->Surface->CrossesItself())
    {
      return Status::Failure("it crosses itself, and is touched by spheres and points only.");
    }
    const Status status = FrictionCone::Check(friction);
    if (status.IsOk())
    {
      gaps = std::make_unique<OrganGaps<Touchable>>(this->Surface, *tool.Skeleton(), friction);
    }
    return status;
  }

protected:
  virtual Status TrackerOf(double radius, const SurfaceFriction& friction,
                           std::unique_ptr<ContactTracker>& tracker) const
  {
    tracker = std::make_unique<NearestPointTrackerOf<Touchable>>(this->Surface, radius, friction);
    return Status::Success();
  }

  std::shared_ptr<const Touchable> Surface;
};

class PublishedContact final : public OrganContact<TouchableRadialModel>
{
public:
  using OrganContact::OrganContact;

  Status MakeGaps(const ToolShape& tool, const SurfaceFriction& friction,
                  std::unique_ptr<ToolGaps>& gaps) const override
  {
    return ContactModel::MakeGaps(tool, friction, gaps);
  }

protected:
  Status TrackerOf(double radius, const SurfaceFriction& friction,
                   std::unique_ptr<ContactTracker>& tracker) const override
  {
    if (friction.Static > 0.0)
    {
      return Status::Failure("The radial method has no friction.");
    }
    tracker = std::make_unique<RadialTracker>(this->Surface, radius);
    return Status::Success();
  }
};
} // namespace

Status MakeOrganContact(std::shared_ptr<const RadialModel> model, RadialContactMode mode,
                        std::shared_ptr<const ContactModel>& contact)
{
  std::shared_ptr<const TouchableRadialModel> surface;
  Status status = TouchableRadialModel::Make(std::move(model), surface);
  if (status.IsOk() && mode == RadialContactMode::Nearest)
  {
    contact = std::make_shared<OrganContact<TouchableRadialModel>>(std::move(surface));
  }
  else if (status.IsOk())
  {
    contact = std::make_shared<PublishedContact>(std::move(surface));
  }
  return status;
}

Status MakeOrganContact(const SurfaceModel& model, std::shared_ptr<const ContactModel>& contact)
{
  std::shared_ptr<const TouchableSurfaceModel> surface;
  Status status = TouchableSurfaceModel::Make(model, surface);
  if (status.IsOk())
  {
    contact = std::make_shared<OrganContact<TouchableSurfaceModel>>(std::move(surface));
  }
  return status;
}
} // namespace palpate
