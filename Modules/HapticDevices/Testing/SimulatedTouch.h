#pragma once

#include "LoopSchedule.h"
#include "ManualClock.h"
#include "Servo.h"
#include "SimulatedDevice.h"
#include "TouchDoubles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace palpate::test
{
/// A servo on an open simulated device, in a manual clock's time.
class SimulatedTouch
{
public:
  SimulatedTouch(const TouchScene& scene, const SimulatedSettings& device,
                 const ServoSettings& settings = ServoSettings())
      : Schedule(0, std::llround(1e9 / settings.Rate)), Device(Time, device),
        Loop(Opened(Device), settings)
  {
    const Status status = this->Loop.Publish(std::make_shared<TouchScene>(scene));
    EXPECT_TRUE(status.IsOk()) << status.Message();
  }

  /// One tick, as a fixed-rate loop would make it. Returns what it did.
  const TouchState& Tick()
  {
    this->Time.WaitUntil(this->Schedule.Deadline());
    TickInfo tick = this->Schedule.Begin(this->Time.Now());
    tick.BootTime = this->Time.BootTime();
    this->Loop.Tick(tick);
    return this->Loop.Latest();
  }
  const TouchState& Tick(int count)
  {
    for (int n = 1; n < count; ++n)
    {
      this->Tick();
    }
    return this->Tick();
  }

  ManualClock Time;

private:
  static SimulatedDevice& Opened(SimulatedDevice& device)
  {
    EXPECT_TRUE(device.Open().IsOk());
    return device;
  }

  LoopSchedule Schedule;

public:
  SimulatedDevice Device;
  Servo Loop;
};

/// A hand that presses and releases: along z from `height` down to -`height` mm and back,
/// `frequency` times a second, while it strokes along x.
inline std::function<Vector3(double)> PressingPath(double height, double frequency)
{
  return [=](double t)
  {
    const double phase = 2.0 * M_PI * frequency * t;
    return Vector3(3.0 * std::sin(0.3 * phase), 0.0, height * std::cos(phase));
  };
}
} // namespace palpate::test
