#pragma once

#include "ContactModel.h"
#include "OrganContact.h"
#include "ProjectedShapes.h"
#include "RandomShapes.h"
#include "WanderingDirection.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace palpate::test
{
inline std::shared_ptr<const RadialModel> Shared(RadialModel model)
{
  return std::make_shared<const RadialModel>(std::move(model));
}

inline std::shared_ptr<const ContactModel>
RadialContact(const RadialModel& model, RadialContactMode mode = RadialContactMode::Nearest)
{
  std::shared_ptr<const ContactModel> contact;
  const Status status = MakeOrganContact(Shared(model), mode, contact);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return contact;
}

inline std::unique_ptr<ContactTracker> TrackerOf(const ContactModel& model, const ToolShape& tool,
                                                 const SurfaceFriction& friction = {})
{
  std::unique_ptr<ContactTracker> tracker;
  const Status status = model.MakeTracker(tool, friction, tracker);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return tracker;
}

/// A tool whose orientation does not matter.
inline ToolPose At(const Vector3& positionWorld)
{
  return {positionWorld, Eigen::Quaterniond::Identity()};
}

/// Moves straight from one place to another in ticks of `step` mm, without the first place.
template <typename Visit>
void MoveStraight(ContactTracker& tracker, const Vector3& from, const Vector3& to, double step,
                  const Visit& visit)
{
  const int ticks = static_cast<int>(std::ceil((to - from).norm() / step));
  for (int tick = 1; tick <= ticks; ++tick)
  {
    const Vector3 probe = from + (1.0 * tick / ticks) * (to - from);
    visit(probe, tracker.Follow(At(probe)));
  }
}
} // namespace palpate::test
