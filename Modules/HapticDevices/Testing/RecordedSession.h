#pragma once

#include "SimulatedTouch.h"
#include "TouchRecorder.h"

#include <string>
#include <vector>

namespace palpate::test
{
inline RecordedSession SessionOf(const HapticDevice& device, const ServoSettings& settings)
{
  return {settings, device.Capabilities()};
}

/// The two scenes of RecordSession.
inline std::vector<std::shared_ptr<const TouchScene>> RecordedScenes()
{
  return {std::make_shared<TouchScene>(WallScene(0.0, {1.0, 0.0005})),
          std::make_shared<TouchScene>(WallScene(1.0, {0.6, 0.001}))};
}

/// Records `ticks` ticks of a hand that presses a wall, with a delayed tick, a fault, rearming and
/// another scene.
inline void RecordSession(const std::string& path, int ticks,
                          const ServoSettings& settings = ServoSettings())
{
  SimulatedSettings device;
  device.Path = PressingPath(3.0, 2.0);
  const auto scenes = RecordedScenes();
  SimulatedTouch touch(*scenes[0], device, settings);
  TouchRecorder recorder;
  ASSERT_TRUE(recorder.Start(path, SessionOf(touch.Device, settings)).IsOk());
  for (int n = 0; n < ticks; ++n)
  {
    if (n == ticks / 4)
    {
      touch.Time.Advance(3'300'000);
    }
    if (n == ticks / 3)
    {
      touch.Time.Suspend(7'000'000); // too short to be a fault
    }
    if (n == ticks / 2)
    {
      touch.Device.Inject(SimulatedFault::NonFinitePosition);
    }
    if (n == ticks / 2 + 10)
    {
      touch.Device.Inject(SimulatedFault::None);
      touch.Loop.Rearm();
    }
    if (n == ticks / 4 * 3)
    {
      ASSERT_TRUE(touch.Loop.Publish(scenes[1]).IsOk());
    }
    touch.Tick();
    if (n % 100 == 0)
    {
      ASSERT_TRUE(recorder.Drain(touch.Loop).IsOk());
    }
  }
  ASSERT_TRUE(recorder.Drain(touch.Loop).IsOk());
  ASSERT_TRUE(recorder.Finish().IsOk());
}
} // namespace palpate::test
