#pragma once

#include "ContactModel.h"
#include "OnDemandField.h"

#include <memory>

namespace palpate
{
/// A structure felt by an on-demand field, as FieldContactModel feels a whole one.
class OnDemandContactModel final : public ContactModel
{
public:
  explicit OnDemandContactModel(std::shared_ptr<OnDemandField> field) : Field(std::move(field)) {}

  Eigen::AlignedBox3d BoundsWorld() const noexcept override;
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override;
  std::size_t Bytes() const noexcept override;

private:
  std::shared_ptr<OnDemandField> Field;
};
} // namespace palpate
