#include "TouchReplay.h"

#include "ManualClock.h"
#include "ReplayDevice.h"
#include "TouchRecordingFormat.h"

#include <cmath>

namespace palpate
{
namespace
{
TouchState WithoutTorques(TouchState state)
{
  const TouchState unknown;
  state.TorqueDevice = unknown.TorqueDevice;
  state.ProbeOrientation = unknown.ProbeOrientation;
  state.ProxyOrientation = unknown.ProxyOrientation;
  return state;
}

void Compare(const TouchState& recorded, const TouchState& recomputed, ReplayComparison& comparison)
{
  ++comparison.Ticks;
  // Encoded: every bit of every field, and no padding.
  if (TouchRecordingFormat::Encode(recorded) != TouchRecordingFormat::Encode(recomputed))
  {
    comparison.FirstDifference = comparison.DifferentTicks == 0
                                     ? static_cast<std::int64_t>(recorded.Tick.Number)
                                     : comparison.FirstDifference;
    ++comparison.DifferentTicks;
  }
  const double difference =
      (Vector3(recorded.ForceDevice) - Vector3(recomputed.ForceDevice)).norm();
  // NaN persists.
  if (!(difference <= comparison.LargestDifference) && !std::isnan(comparison.LargestDifference))
  {
    comparison.LargestDifference = difference;
  }
}

// The servo itself issues the command of pressing the pedal.
void LeadDrill(Servo& servo, const TouchState& tick, bool wasDrilling)
{
  servo.RunDrill(tick.IsDrilling);
  if (tick.Command != DrillCommand::None && (tick.IsDrilling || !wasDrilling))
  {
    servo.Command(tick.Command);
  }
}
} // namespace

Status ReplayTouch(const std::shared_ptr<const TouchRecording>& recording,
                   const std::vector<std::shared_ptr<const TouchScene>>& scenes,
                   ReplayComparison& comparison, const BeforeReplayedTick& beforeTick)
{
  if (recording->Ticks.empty())
  {
    return Status::Failure("The recording has no ticks.");
  }
  ManualClock clock(recording->Ticks.front().Tick.Started);
  ReplayDevice device(clock, recording);
  Status status = device.Open();
  Servo servo(device, recording->Session.Settings);
  std::uint64_t scene = 0;
  bool wasOff = false;
  bool isDrilling = false;
  for (std::size_t i = 0; i < recording->Ticks.size() && status.IsOk(); ++i)
  {
    const TouchState& tick = recording->Ticks[i];
    if (tick.Scene > scene)
    {
      scene = tick.Scene;
      status = scene <= scenes.size()
                   ? servo.Publish(scenes[scene - 1],
                                   tick.WasContinued ? SceneEntry::Continuing : SceneEntry::FadeIn)
                   : Status::Failure("The recording takes over more scenes than were given.");
    }
    if (tick.WasRearmed)
    {
      servo.Rearm();
    }
    tick.IsClutched ? servo.HoldClutch() : servo.ReleaseClutch();
    LeadDrill(servo, tick, isDrilling);
    isDrilling = tick.IsDrilling;
    if (beforeTick)
    {
      beforeTick(tick);
    }
    const bool isOff = tick.Safety.Fault == SafetyFault::SwitchedOff;
    if (isOff && (!wasOff || tick.WasRearmed))
    {
      servo.SwitchOff();
    }
    wasOff = isOff;
    clock.WaitUntil(tick.Tick.Started);
    servo.Tick(tick.Tick);
    const TouchState& again = servo.Latest();
    Compare(tick, recording->HasTorques ? again : WithoutTorques(again), comparison);
  }
  return status;
}
} // namespace palpate
