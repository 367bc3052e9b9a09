// The whole way: servo, driver, wire, board, motors, mechanism and a hand that gives way.
#include "FalconDevice.h"

#include "LoopSchedule.h"
#include "ManualClock.h"
#include "Servo.h"
#include "TouchDoubles.h"
#include "VirtualFalconLink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr std::int64_t Period = 1'000'000; // ns
constexpr double WallHeight = -10.0;       // mm, device's frame

// A Falcon whose firmware runs; its hand homes it, and then goes where it is told.
class FalconTouchTest : public testing::Test
{
protected:
  FalconTouchTest()
  {
    test::VirtualMechanismSettings& hand = this->Falcon.Mechanism().Settings;
    hand.CountsPerNewtonMillimeter = 6.6;
    hand.Path = [this](double t) -> Vector3
    {
      return this->IsHoming ? Vector3(0.0, 0.0, 130.0 - 45.0 * std::cos(4.0 * M_PI * t))
                            : this->Target;
    };
    this->Falcon.StartLoaded();
    EXPECT_TRUE(this->Device.Open().IsOk());
    DeviceSample sample;
    for (int n = 0; n < 5000 && this->Device.State() != DeviceState::Ready; ++n)
    {
      this->Time.Advance(Period);
      EXPECT_TRUE(this->Device.Read(sample) && this->Device.Apply(Vector3::Zero()));
    }
    this->IsHoming = false;
  }

  // Feels a wall below, which the hand presses to `depth` (mm) if nothing stopped it.
  void Touch(Servo& servo, double depth)
  {
    LoopSchedule schedule(this->Time.Now(), Period);
    const auto scene = std::make_shared<TouchScene>(test::WallScene(WallHeight, {1.0, 0.001}));
    ASSERT_TRUE(servo.Publish(scene).IsOk());
    for (int n = 0; n < 3000; ++n)
    {
      // A second free, a second down, a second there.
      const double part = std::clamp(1e-3 * n - 1.0, 0.0, 1.0);
      this->Target[2] = 125.0 + part * (WallHeight - depth);
      this->Tick(servo, schedule);
    }
    for (int n = 0; n < 500; ++n)
    {
      const double height = this->Tick(servo, schedule).Sample.Position.Z;
      this->Lowest = std::min(this->Lowest, height);
      this->Highest = std::max(this->Highest, height);
    }
    this->Schedule = schedule;
  }

  TouchState Tick(Servo& servo, LoopSchedule& schedule)
  {
    this->Time.WaitUntil(schedule.Deadline());
    servo.Tick(schedule.Begin(this->Time.Now()));
    return servo.Latest();
  }

  ManualClock Time{1'000'000'000};
  test::VirtualFalcon Falcon;
  FalconDevice Device{Time, std::make_unique<test::VirtualFalconLink>(Falcon, Time), {}};
  LoopSchedule Schedule{0, Period};
  bool IsHoming = true;
  Vector3 Target{0.0, 0.0, 125.0};
  double Lowest = 1e9;
  double Highest = -1e9;
};

TEST_F(FalconTouchTest, AWallIsFeltWithItsStiffnessAndStandsStill)
{
  Servo servo(this->Device, ServoSettings());
  this->Touch(servo, 3.0);
  EXPECT_EQ(servo.Latest().Safety.Fault, SafetyFault::None);
  // The wall of 1 N/mm and the hand of 0.5 N/mm share 3 mm: 1 mm and 1 N. Friction of 0.2 N may
  // hold 0.13 mm beside it, and counts are 0.04 mm.
  EXPECT_NEAR(this->Falcon.Mechanism().MotorForce()[2], 1.0, 0.18);
  EXPECT_NEAR(this->Lowest, WallHeight - 1.0, 0.18);
  EXPECT_LT(this->Highest - this->Lowest, 0.1) << "it does not hum";
}

TEST_F(FalconTouchTest, UnpluggedInContactTheServoSaysSoWithinTwoTicks)
{
  Servo servo(this->Device, ServoSettings());
  this->Touch(servo, 6.0);
  ASSERT_GT(servo.Latest().ForceDevice.Z, 1.0);
  this->Falcon.Unplug(this->Time.Now());
  this->Tick(servo, this->Schedule);
  const TouchState state = this->Tick(servo, this->Schedule);
  EXPECT_EQ(Vector3(state.ForceDevice), Vector3::Zero());
  EXPECT_EQ(state.Safety.Fault, SafetyFault::DeviceFailed);
  EXPECT_EQ(state.State, DeviceState::Error);
}

TEST_F(FalconTouchTest, MuteInContactThereIsNoForceBeforeTheDriverGivesUp)
{
  Servo servo(this->Device, ServoSettings());
  this->Touch(servo, 6.0);
  this->Falcon.Faults.Spoil = [](test::VirtualFalconAnswer& answer) { answer.Bytes.clear(); };
  for (int n = 0; n < 50; ++n)
  {
    this->Tick(servo, this->Schedule);
  }
  EXPECT_NE(servo.Latest().Safety.Fault, SafetyFault::None);
  EXPECT_EQ(this->Falcon.Mechanism().MotorForce(), Vector3::Zero());
}
} // namespace
} // namespace palpate
