#pragma once

#include "ContactModel.h"
#include "ParametricTouchSurface.h"

#include <memory>

namespace palpate
{
/// A structure whose surface is three coordinates in spherical harmonics. Supports spherical tools,
/// with friction.
class ParametricContactModel final : public ContactModel
{
public:
  /// Fails as ParametricTouchSurface::Make.
  static Status Make(const ParametricSphericalSurface& surface,
                     std::shared_ptr<const ContactModel>& contact);

  Eigen::AlignedBox3d BoundsWorld() const noexcept override;
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override;
  std::size_t Bytes() const noexcept override;

private:
  explicit ParametricContactModel(std::shared_ptr<const ParametricTouchSurface> surface);

  std::shared_ptr<const ParametricTouchSurface> Surface;
};
} // namespace palpate
