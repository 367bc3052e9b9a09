#include "OnDemandHarmonicModel.h"

#include "OnDemandHarmonicTracker.h"

namespace palpate
{
Status OnDemandHarmonicModel::MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                                          std::unique_ptr<ContactTracker>& tracker) const
{
  std::shared_ptr<TrackerSlot> slot;
  Status status = this->Harmonics->Attach(this->Rung, tool, friction, slot);
  if (status.IsOk())
  {
    tracker = std::make_unique<OnDemandHarmonicTracker>(this->Harmonics, std::move(slot),
                                                        tool.BoundingRadius());
  }
  return status;
}
} // namespace palpate
