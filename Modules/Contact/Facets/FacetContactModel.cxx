#include "FacetContactModel.h"

#include "FacetGaps.h"
#include "FacetTracker.h"
#include "FrictionCone.h"

namespace palpate
{
Status FacetContactModel::Make(const std::vector<Vector3>& pointsWorld,
                               const std::vector<FacetTree::Triangle>& triangles,
                               std::shared_ptr<const ContactModel>& contact)
{
  std::shared_ptr<const FacetTree> tree;
  Status status = FacetTree::Make(pointsWorld, triangles, tree);
  if (status.IsOk())
  {
    contact.reset(new FacetContactModel(std::move(tree)));
  }
  return status;
}

Status FacetContactModel::MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
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
    return Status::Failure("Triangle meshes support spherical and point tools only.");
  }
  tracker = std::make_unique<FacetTracker>(this->Tree, tool.Radius(), friction);
  return Status::Success();
}

Status FacetContactModel::MakeGaps(const ToolShape& tool, const SurfaceFriction& friction,
                                   std::unique_ptr<ToolGaps>& gaps) const
{
  const Status status = FrictionCone::Check(friction);
  if (status.IsOk())
  {
    gaps = std::make_unique<FacetGaps>(this->Tree, *tool.Skeleton(), friction);
  }
  return status;
}
} // namespace palpate
