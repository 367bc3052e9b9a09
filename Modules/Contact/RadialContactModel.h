#pragma once

#include "ContactModel.h"

#include <memory>

namespace palpate
{
class RadialModel;
class TouchableRadialModel;

/// How a tool's proxy is placed on a radial model.
enum class RadialContactMode
{
  Nearest, ///< at the nearest point, coherent from tick to tick, with friction
  Radial   ///< on the probe's own radius: the published method, without friction
};

/// A structure whose surface is a radius in spherical harmonics. Supports spherical tools.
class RadialContactModel final : public ContactModel
{
public:
  /// Fails as TouchableRadialModel::Make.
  static Status Make(std::shared_ptr<const RadialModel> model, RadialContactMode mode,
                     std::shared_ptr<const ContactModel>& contact);

  Eigen::AlignedBox3d BoundsWorld() const noexcept override;
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override;
  std::size_t Bytes() const noexcept override;

private:
  RadialContactModel(std::shared_ptr<const TouchableRadialModel> surface, RadialContactMode mode);

  std::shared_ptr<const TouchableRadialModel> Surface;
  RadialContactMode Mode;
};
} // namespace palpate
