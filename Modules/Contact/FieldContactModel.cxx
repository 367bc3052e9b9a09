#include "FieldContactModel.h"

#include "FieldGaps.h"
#include "FieldProxyTracker.h"
#include "FrictionCone.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
Status FieldContactModel::Make(const std::shared_ptr<const ScalarField>& field, int material,
                               std::shared_ptr<const ContactModel>& contact)
{
  std::shared_ptr<const FieldSolid> solid;
  Status status = FieldSolid::Make(field, material, solid);
  if (status.IsOk())
  {
    contact.reset(new FieldContactModel(std::move(solid)));
  }
  return status;
}

int FieldContactModel::PointCountFor(double radius, double voxelSize) noexcept
{
  // A place of a sphere is up to 0.8 sqrt(area / count) from the nearest point, where the sphere is
  // 4 radius / count lower.
  const double radii = radius / voxelSize;
  constexpr double Lower = 0.05;
  const double wanted = std::max(4.0 * radii / Lower, 4.0 * M_PI * radii * radii);
  return static_cast<int>(std::clamp(std::ceil(wanted), 1.0 * FewestPoints, 1.0 * MostPoints));
}

ToolShape FieldContactModel::ShellFor(const ToolShape& tool, double voxelSize)
{
  return tool.Points().empty()
             ? ToolShape::SpherePoints(tool.Radius(), PointCountFor(tool.Radius(), voxelSize))
             : tool;
}

Status FieldContactModel::MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                                      std::unique_ptr<ContactTracker>& tracker) const
{
  for (Status status : {tool.Check(), FrictionCone::Check(friction)})
  {
    if (!status.IsOk())
    {
      return status;
    }
  }
  const ToolShape shell = ShellFor(tool, this->Solid->VoxelSize());
  tracker = std::make_unique<FieldProxyTracker>(this->Solid, shell, friction);
  return Status::Success();
}

Status FieldContactModel::MakeGaps(const ToolShape& tool, const SurfaceFriction& friction,
                                   std::unique_ptr<ToolGaps>& gaps) const
{
  const Status status = FrictionCone::Check(friction);
  if (status.IsOk())
  {
    // So that hardly anything as wide as a voxel slips between the points.
    gaps = std::make_unique<FieldGaps>(this->Solid, tool.WithSpacing(this->Solid->VoxelSize()),
                                       friction);
  }
  return status;
}
} // namespace palpate
