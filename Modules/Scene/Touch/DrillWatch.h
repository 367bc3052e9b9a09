#pragma once

#include "DrillContext.h"
#include "PalpateSceneModule.h"
#include "TouchState.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// Distance of the drill to a forbidden structure over time.
struct DrillApproach
{
  std::string Name;
  double Distance = 0.0;      ///< mm, now; negative inside
  double Least = 0.0;         ///< mm, smallest so far
  double LeastTime = 0.0;     ///< s, time of the smallest distance
  double AlarmDistance = 0.0; ///< mm
  double AlarmSeconds = 0.0;  ///< s within it
  bool IsAlarmed = false;     ///< now
};

/// Monitors the drill's distances to forbidden structures and raises alarms.
class PALPATESCENE_EXPORT DrillWatch
{
public:
  explicit DrillWatch(std::shared_ptr<DrillContext> context);

  /// Call at every tick or less often; `time` in s. Returns one message per alarm that begins.
  std::vector<std::string> Look(double time, const TouchState& state);

  const std::vector<DrillApproach>& Approaches() const { return this->Known; }

private:
  std::shared_ptr<DrillContext> Context;
  std::vector<DrillApproach> Known;
  double Last = 0.0;
  bool HasLooked = false;
};
} // namespace palpate
