#pragma once

#include "ContactModel.h"

#include <memory>

namespace palpate
{
class SurfaceModel;
class TouchableSurfaceModel;

/// A structure whose surface is three coordinates in spherical harmonics. Supports spherical tools,
/// with friction.
class SurfaceContactModel final : public ContactModel
{
public:
  /// Fails as TouchableSurfaceModel::Make.
  static Status Make(const SurfaceModel& surface, std::shared_ptr<const ContactModel>& contact);

  Eigen::AlignedBox3d BoundsWorld() const noexcept override;
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override;
  std::size_t Bytes() const noexcept override;

private:
  explicit SurfaceContactModel(std::shared_ptr<const TouchableSurfaceModel> surface);

  std::shared_ptr<const TouchableSurfaceModel> Surface;
};
} // namespace palpate
