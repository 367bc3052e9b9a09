#pragma once

#include "SafetyCases.h"
#include "Servo.h"
#include "TouchDoubles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::test
{
/// A servo on a scripted device at 1 kHz, driven tick by tick.
class ServoRun
{
public:
  explicit ServoRun(const TouchScene& scene, const ServoSettings& settings = ServoSettings(),
                    const DeviceCapabilities& device = ScriptedDevice().Abilities)
      : Device(device), Loop(this->Device, settings)
  {
    const Status status = this->Loop.Publish(std::make_shared<TouchScene>(scene));
    EXPECT_TRUE(status.IsOk()) << status.Message();
  }

  /// One tick with the device at a place (mm, its own frame). Returns the applied force (N).
  Vector3 TickAt(const Vector3& position)
  {
    const TickObservation healthy = HealthyTick(this->Ticks++, position);
    this->Device.Next.Position = position;
    this->Device.Next.Time = healthy.Sample.Time;
    this->Loop.Tick(healthy.Tick);
    return this->Device.Applied;
  }

  /// Ticks along a straight path of the hand from one place to another, 0.05 mm a tick, and then
  /// rests there. Returns the force (N).
  Vector3 MoveAndRest(const Vector3& from, const Vector3& to)
  {
    const int steps = static_cast<int>(std::ceil((to - from).norm() / 0.05));
    for (int n = 0; n < steps; ++n)
    {
      this->TickAt(from + (1.0 * n / steps) * (to - from));
    }
    return this->RestAt(to);
  }

  /// Ticks at one place until all fading and filters settle.
  Vector3 RestAt(const Vector3& position)
  {
    Vector3 force = Vector3::Zero();
    for (int n = 0; n < 600; ++n)
    {
      force = this->TickAt(position);
    }
    return force;
  }

private:
  std::uint64_t Ticks = 0;

public:
  ScriptedDevice Device;
  Servo Loop;
};
} // namespace palpate::test
