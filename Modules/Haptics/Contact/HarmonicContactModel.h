#pragma once

#include "ContactModel.h"
#include "HarmonicSurface.h"

#include <memory>

namespace palpate
{
/// How a tool's proxy is placed on a star-shaped surface.
enum class HarmonicContactMode
{
  Nearest, ///< at the nearest point, coherent from tick to tick, with friction
  Radial   ///< on the probe's own radius: the published method, without friction
};

/// A structure whose surface is a radius in spherical harmonics. Supports spherical tools.
class HarmonicContactModel final : public ContactModel
{
public:
  /// Fails as HarmonicSurface::Make.
  static Status Make(std::shared_ptr<const SphericalHarmonicModel> model, HarmonicContactMode mode,
                     std::shared_ptr<const ContactModel>& contact);

  Eigen::AlignedBox3d BoundsWorld() const noexcept override { return this->Surface->BoundsWorld(); }
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override;
  std::size_t Bytes() const noexcept override;

private:
  HarmonicContactModel(std::shared_ptr<const HarmonicSurface> surface, HarmonicContactMode mode);

  std::shared_ptr<const HarmonicSurface> Surface;
  HarmonicContactMode Mode;
};
} // namespace palpate
