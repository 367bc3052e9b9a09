#pragma once

#include "ContactModel.h"
#include "OnDemandHarmonics.h"

#include <memory>

namespace palpate
{
/// What lies beneath an on-demand structure of spherical harmonics: its coarse body. Counts the
/// ticks that touch it.
class CoarseHarmonicModel final : public ContactModel
{
public:
  explicit CoarseHarmonicModel(std::shared_ptr<OnDemandHarmonics> harmonics)
      : Harmonics(std::move(harmonics))
  {
  }

  Eigen::AlignedBox3d BoundsWorld() const noexcept override
  {
    return this->Harmonics->Coarse()->BoundsWorld();
  }
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override;

private:
  std::shared_ptr<OnDemandHarmonics> Harmonics;
};
} // namespace palpate
