#include "CoarseHarmonicModel.h"

#include <utility>

namespace palpate
{
namespace
{
class CountingTracker final : public ContactTracker
{
public:
  CountingTracker(std::shared_ptr<OnDemandHarmonics> harmonics,
                  std::unique_ptr<ContactTracker> coarse)
      : Harmonics(std::move(harmonics)), Coarse(std::move(coarse))
  {
  }

  const Contact& Follow(const ToolPose& pose) noexcept override
  {
    const Contact& felt = this->Coarse->Follow(pose);
    if (felt.IsTouching)
    {
      this->Harmonics->CountCoarseTick();
    }
    return felt;
  }
  void Release() noexcept override { this->Coarse->Release(); }
  std::size_t Bytes() const noexcept override { return sizeof(*this) + this->Coarse->Bytes(); }

private:
  std::shared_ptr<OnDemandHarmonics> Harmonics;
  std::unique_ptr<ContactTracker> Coarse;
};
} // namespace

Status CoarseHarmonicModel::MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                                        std::unique_ptr<ContactTracker>& tracker) const
{
  std::unique_ptr<ContactTracker> coarse;
  Status status = this->Harmonics->Coarse()->MakeTracker(tool, friction, coarse);
  if (status.IsOk())
  {
    tracker = std::make_unique<CountingTracker>(this->Harmonics, std::move(coarse));
  }
  return status;
}
} // namespace palpate
