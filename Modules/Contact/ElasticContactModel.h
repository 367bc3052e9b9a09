#pragma once

#include "ContactModel.h"

#include <memory>

namespace palpate
{
class ComplianceAtlas;
class ComplianceMaps;
class RadialModel;
class TouchableRadialModel;

/// A structure that yields: a radial model with the compliance of its places. Supports
/// spherical tools. Its force is its own, in N in the world; of the scene's force law only the
/// damping counts.
class ElasticContactModel final : public ContactModel
{
public:
  /// `maps` were made for `model`. Fails as TouchableRadialModel::Make and ComplianceMaps::Check.
  static Status Make(std::shared_ptr<const RadialModel> model, const ComplianceMaps& maps,
                     std::shared_ptr<const ContactModel>& contact);

  Eigen::AlignedBox3d BoundsWorld() const noexcept override;
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override;
  double OwnStiffness(const ToolShape& tool) const override;
  std::size_t Bytes() const noexcept override;

private:
  ElasticContactModel(std::shared_ptr<const TouchableRadialModel> surface,
                      std::shared_ptr<const ComplianceAtlas> atlas);

  std::shared_ptr<const TouchableRadialModel> Surface;
  std::shared_ptr<const ComplianceAtlas> Atlas;
};
} // namespace palpate
