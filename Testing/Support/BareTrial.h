#pragma once

#include "StabilityProbe.h"

namespace palpate::test
{
/// The bounds only: no ramp, slew limit or energy observer helps.
inline StabilityTrial BareTrial(const Vector3& outward, double rate = 1000.0)
{
  StabilityTrial trial;
  trial.Outward = outward;
  trial.Device.Rate = rate;
  trial.Device.MaximumStiffness = 0.0;
  trial.Device.MaximumDamping = 0.0;
  trial.Device.MaximumForce = 1000.0;
  trial.Device.Resolution = 0.0;
  trial.Device.Hand.Friction = 0.0;
  trial.Loop.Rate = rate;
  trial.Loop.RampDuration = 0.0;
  trial.Loop.MaximumSlew = 1e9;
  trial.Loop.RecordedTicks = 0;
  return trial;
}
} // namespace palpate::test
