#pragma once

#include "ContactModel.h"
#include "ManualClock.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

namespace palpate::test
{
/// Duration (ns) of a query to a SlowModel; may change at any time.
using QuestionCost = std::shared_ptr<const std::atomic<std::int64_t>>;

/// Wraps a model and makes every query take some of a clock's time.
class SlowModel final : public ContactModel
{
public:
  /// Keeps the address of the clock.
  SlowModel(std::shared_ptr<const ContactModel> quick, ManualClock& clock, QuestionCost cost)
      : Quick(std::move(quick)), Time(clock), Cost(std::move(cost))
  {
  }
  Eigen::AlignedBox3d BoundsWorld() const noexcept override { return this->Quick->BoundsWorld(); }
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override
  {
    std::unique_ptr<ContactTracker> quick;
    Status status = this->Quick->MakeTracker(tool, friction, quick);
    if (status.IsOk())
    {
      tracker = std::make_unique<Tracker>(std::move(quick), this->Time, this->Cost);
    }
    return status;
  }

private:
  class Tracker final : public ContactTracker
  {
  public:
    Tracker(std::unique_ptr<ContactTracker> quick, ManualClock& clock, QuestionCost cost)
        : Quick(std::move(quick)), Time(clock), Cost(std::move(cost))
    {
    }
    const Contact& Follow(const ToolPose& pose) noexcept override
    {
      this->Time.Advance(*this->Cost);
      return this->Quick->Follow(pose);
    }
    void Release() noexcept override { this->Quick->Release(); }
    bool IsFreeAt(const ToolPose& pose) noexcept override
    {
      this->Time.Advance(*this->Cost);
      return this->Quick->IsFreeAt(pose);
    }
    double SurfaceTolerance() const noexcept override { return this->Quick->SurfaceTolerance(); }

  private:
    std::unique_ptr<ContactTracker> Quick;
    ManualClock& Time;
    QuestionCost Cost;
  };

  std::shared_ptr<const ContactModel> Quick;
  ManualClock& Time;
  QuestionCost Cost;
};
} // namespace palpate::test
