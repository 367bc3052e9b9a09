#include "ElasticContactModel.h"

#include "ComplianceAtlas.h"
#include "ElasticTracker.h"
#include "FrictionCone.h"
#include "SphereQuadrature.h"
#include "TouchableRadialModel.h"

#include <algorithm>
#include <utility>

namespace palpate
{
Status ElasticContactModel::Make(std::shared_ptr<const RadialModel> model,
                                 const ComplianceMaps& maps,
                                 std::shared_ptr<const ContactModel>& contact)
{
  std::shared_ptr<const TouchableRadialModel> surface;
  const Status isBody = maps.Check();
  Status status = isBody.IsOk() ? TouchableRadialModel::Make(std::move(model), surface) : isBody;
  if (status.IsOk())
  {
    contact.reset(
        new ElasticContactModel(std::move(surface), std::make_shared<const ComplianceAtlas>(maps)));
  }
  return status;
}

ElasticContactModel::ElasticContactModel(std::shared_ptr<const TouchableRadialModel> surface,
                                         std::shared_ptr<const ComplianceAtlas> atlas)
    : Surface(std::move(surface)), Atlas(std::move(atlas))
{
}

Eigen::AlignedBox3d ElasticContactModel::BoundsWorld() const noexcept
{
  return this->Surface->BoundsWorld();
}

std::size_t ElasticContactModel::Bytes() const noexcept
{
  return this->Surface->Bytes() + this->Atlas->Bytes();
}

// At half the tool's radius, up to which the force is valid.
double ElasticContactModel::OwnStiffness(const ToolShape& tool) const
{
  constexpr int Degree = 16;
  double stiffest = 0.0;
  for (const Vector3& direction : SphereQuadrature(Degree).Directions)
  {
    const ElasticForce force = ElasticForce::Of(*this->Atlas, this->Surface->Model(), direction,
                                                0.5 * tool.Radius(), tool.Radius());
    stiffest = std::max(stiffest, force.Slope);
  }
  return stiffest;
}

Status ElasticContactModel::MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                                        std::unique_ptr<ContactTracker>& tracker) const
{
  for (Status status : {tool.Check(), FrictionCone::Check(friction)})
  {
    if (!status.IsOk())
    {
      return status;
    }
  }
  if (!tool.IsSphere() || !(tool.Radius() > 0.0))
  {
    return Status::Failure("A structure that yields is touched by a sphere, not by a point or by "
                           "another tool.");
  }
  tracker = std::make_unique<ElasticTracker>(this->Surface, this->Atlas, tool.Radius(), friction);
  return Status::Success();
}
} // namespace palpate
