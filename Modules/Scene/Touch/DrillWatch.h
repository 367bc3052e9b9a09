#pragma once

#include "DrillBench.h"
#include "PalpateSceneModule.h"
#include "TouchState.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// How near the drill came to what is forbidden.
struct DrillApproach
{
  std::string Name;
  double Distance = 0.0;      ///< mm, now; negative inside
  double Least = 0.0;         ///< mm, so far
  double LeastTime = 0.0;     ///< s, when that was
  double AlarmDistance = 0.0; ///< mm
  double AlarmSeconds = 0.0;  ///< s within it
  bool IsAlarmed = false;     ///< now
};

/// Looks where a drill is, tick by tick or now and then, and raises alarms.
class PALPATESCENE_EXPORT DrillWatch
{
public:
  explicit DrillWatch(std::shared_ptr<DrillBench> bench);

  /// `time` in s. What is to be said now: a sentence for each alarm that begins.
  std::vector<std::string> Look(double time, const TouchState& state);

  const std::vector<DrillApproach>& Approaches() const { return this->Known; }

private:
  std::shared_ptr<DrillBench> Bench;
  std::vector<DrillApproach> Known;
  double Last = 0.0;
  bool HasLooked = false;
};
} // namespace palpate
