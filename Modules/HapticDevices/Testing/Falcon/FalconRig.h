#pragma once

#include "FalconDevice.h"
#include "LoopSchedule.h"
#include "ManualClock.h"
#include "Servo.h"
#include "TouchDoubles.h"
#include "VirtualFalconLink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace palpate::test
{
/// The whole chain in virtual time: servo, driver, wire, board, motors, mechanism and a compliant
/// hand. The firmware is running; the hand homes the Falcon and then presses a wall.
class FalconRig
{
public:
  static constexpr std::int64_t Period = 1'000'000; // ns
  static constexpr double WallHeight = -10.0;       // mm, device's frame

  explicit FalconRig(const FalconSettings& settings = {}) : Device(this->Time, MakeLink(), settings)
  {
    VirtualMechanismSettings& hand = this->Falcon.Mechanism().Settings;
    hand.CountsPerNewtonMillimeter = settings.Calibration.CountsPerNewtonMillimeter;
    hand.Path = [this](double t) -> Vector3
    {
      return this->IsHoming ? Vector3(0.0, 0.0, 130.0 - 45.0 * std::cos(4.0 * M_PI * t))
                            : this->Target;
    };
    this->Falcon.StartLoaded();
    this->OpenAndHome();
  }

  void OpenAndHome()
  {
    this->IsHoming = true;
    EXPECT_TRUE(this->Device.Open().IsOk());
    DeviceSample sample;
    for (int n = 0; n < 5000 && this->Device.State() != DeviceState::Ready; ++n)
    {
      this->Time.Advance(Period);
      EXPECT_TRUE(this->Device.Read(sample) && this->Device.Apply(Vector3::Zero()));
    }
    this->IsHoming = false;
  }

  /// Runs a servo with a wall below, which the hand reaches within three seconds and would press to
  /// `depth` (mm).
  void Press(Servo& servo, double depth, const std::shared_ptr<WallControl>& control = nullptr)
  {
    this->Schedule = LoopSchedule(this->Time.Now(), Period);
    ASSERT_TRUE(
        servo.Publish(std::make_shared<TouchScene>(WallScene(WallHeight, {1.0, 0.001}, control)))
            .IsOk());
    for (int n = 0; n < 3000; ++n)
    {
      // A second free, a second down, a second held.
      const double part = std::clamp(1e-3 * n - 1.0, 0.0, 1.0);
      this->Target[2] = 125.0 + part * (WallHeight - depth);
      this->Tick(servo);
    }
  }

  TouchState Tick(Servo& servo)
  {
    this->Time.WaitUntil(this->Schedule.Deadline());
    servo.Tick(this->Schedule.Begin(this->Time.Now()));
    return servo.Latest();
  }

  /// The packets that the board has received so far, in order.
  const std::vector<VirtualFalconBoard::Order>& Received()
  {
    this->Falcon.NextDue(this->Time.Now());
    return this->Falcon.Board().Received();
  }
  bool HasTorque() { return this->Received().back().HasTorque(); }

  ManualClock Time{1'000'000'000};
  VirtualFalcon Falcon;
  VirtualFalconLink* Cable = nullptr;
  FalconDevice Device;
  LoopSchedule Schedule{0, Period};
  bool IsHoming = true;
  Vector3 Target{0.0, 0.0, 125.0}; // mm, from the base

private:
  std::unique_ptr<VirtualFalconLink> MakeLink()
  {
    auto link = std::make_unique<VirtualFalconLink>(this->Falcon, this->Time);
    this->Cable = link.get();
    return link;
  }
};
} // namespace palpate::test
