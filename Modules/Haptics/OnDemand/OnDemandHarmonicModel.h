#pragma once

#include "ContactModel.h"
#include "OnDemandHarmonics.h"

#include <memory>

namespace palpate
{
/// One rung of an on-demand structure of spherical harmonics: the model itself or a stand-in, felt
/// as HarmonicContactModel feels it while it is at hand.
class OnDemandHarmonicModel final : public ContactModel
{
public:
  OnDemandHarmonicModel(std::shared_ptr<OnDemandHarmonics> harmonics, std::size_t rung)
      : Harmonics(std::move(harmonics)), Rung(rung)
  {
  }

  Eigen::AlignedBox3d BoundsWorld() const noexcept override
  {
    return this->Harmonics->BoundsOf(this->Rung);
  }
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override;
  /// Of the whole structure at its first rung, 0 at the others.
  std::size_t Bytes() const noexcept override
  {
    return this->Rung == 0 ? this->Harmonics->Bytes() : 0;
  }

private:
  std::shared_ptr<OnDemandHarmonics> Harmonics;
  std::size_t Rung;
};
} // namespace palpate
