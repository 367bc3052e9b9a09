#include "FalconRig.h"

#include "ProofCount.h"

namespace palpate::falcon_touch_test
{
namespace
{
class FalconTouchTest : public testing::Test, protected test::FalconRig
{
};

TEST_F(FalconTouchTest, WallHasStiffnessAndDoesNotVibrate)
{
  Servo servo(this->Device, ServoSettings());
  this->Press(servo, 3.0);
  double lowest = 1e9;
  double highest = -1e9;
  for (int n = 0; n < 500; ++n)
  {
    const double height = this->Tick(servo).Sample.Position.Z;
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  EXPECT_EQ(servo.Latest().Safety.Fault, SafetyFault::None);
  // The wall of 1 N/mm and the hand of 0.5 N/mm share 3 mm: 1 mm and 1 N. Friction of 0.2 N may
  // hold it 0.13 mm off, and counts are 0.04 mm.
  EXPECT_NEAR(this->Falcon.Mechanism().MotorForce()[2], 1.0, 0.18);
  EXPECT_NEAR(lowest, WallHeight - 1.0, 0.18);
  EXPECT_LT(highest - lowest, 0.1) << "it vibrates";
}

// The chip holds received data until its latency timer of 1 ms ends.
TEST_F(FalconTouchTest, AlmostEveryPeriodHasReplyForMinutes)
{
  const int seconds = test::ProofCount(60, 600);
  const int ticks = 1000 * seconds;
  Servo servo(this->Device, ServoSettings());
  const auto scene = std::make_shared<TouchScene>(test::WallScene(WallHeight, {1.0, 0.001}));
  ASSERT_TRUE(servo.Publish(scene).IsOk());
  this->Schedule = LoopSchedule(this->Time.Now(), Period);
  std::uint64_t last = 0;
  int heard = 0;
  int silence = 0;
  int longestSilence = 0;
  int touched = 0;
  for (int n = 0; n < ticks; ++n)
  {
    // Twice in three seconds 3 mm into the wall and as far out of it.
    this->Target[2] = 125.0 + WallHeight + 3.0 * std::cos(2e-3 * M_PI / 1.5 * n);
    const TouchState state = this->Tick(servo);
    ASSERT_EQ(state.Safety.Fault, SafetyFault::None) << Describe(state.Safety.Fault) << " at " << n;
    const bool isNew = state.Sample.Sequence != last;
    last = state.Sample.Sequence;
    heard += isNew ? 1 : 0;
    silence = isNew ? 0 : silence + 1;
    longestSilence = std::max(longestSilence, silence);
    touched += state.Structure >= 0 ? 1 : 0;
  }
  const FalconStatistics statistics = this->Device.Statistics();
  this->RecordProperty("samples_per_second", std::to_string(heard / double(seconds)));
  this->RecordProperty("longest_silence_ticks", longestSilence);
  this->RecordProperty("replies_lost", std::to_string(statistics.Lost));
  EXPECT_GE(heard, 950 * seconds);
  EXPECT_LE(longestSilence, 3); // the watchdog's limit for this device
  EXPECT_EQ(statistics.Lost, 0u);
  EXPECT_GT(touched, ticks / 4);
  EXPECT_LT(touched, 3 * ticks / 4);
}

TEST_F(FalconTouchTest, ServoReportsUnpluggingWithinTwoTicks)
{
  Servo servo(this->Device, ServoSettings());
  this->Press(servo, 6.0);
  ASSERT_GT(servo.Latest().ForceDevice.Z, 1.0);
  this->Falcon.Unplug(this->Time.Now());
  this->Tick(servo);
  const TouchState state = this->Tick(servo);
  EXPECT_EQ(Vector3(state.ForceDevice), Vector3::Zero());
  EXPECT_EQ(state.Safety.Fault, SafetyFault::DeviceFailed);
  EXPECT_EQ(state.State, DeviceState::Error);
}

// 0.1 kg of handle that the motors carry in addition.
class CarryingFalconTouchTest : public testing::Test, protected test::FalconRig
{
protected:
  CarryingFalconTouchTest() : FalconRig(Carrying()) {}
  static FalconSettings Carrying()
  {
    FalconSettings settings;
    settings.Calibration.CarriedMass = Mass;
    return settings;
  }
  static constexpr double Mass = 0.1;           // kg
  static constexpr double Weight = 9.81 * Mass; // N
};

TEST_F(CarryingFalconTouchTest, CarriesHandleAfterRampAndRecordsIt)
{
  Servo servo(this->Device, ServoSettings());
  this->Schedule = LoopSchedule(this->Time.Now(), Period);
  double before = 0.0;
  double largestStep = 0.0;
  for (int n = 0; n < 1000; ++n)
  {
    const double force = this->Tick(servo).ForceDevice.Y;
    largestStep = std::max(largestStep, force - before);
    before = force;
  }
  EXPECT_NEAR(before, Weight, 1e-12);
  // A ramp of 0.3 s at 1 kHz, plus a tenth for ticks whose period is not exact.
  EXPECT_LT(largestStep, 1.1 * Weight / 300.0);
  // Half a motor value of 160 per newton and leg.
  EXPECT_NEAR(this->Falcon.Mechanism().MotorForce()[1], Weight, 0.01);
}

TEST_F(CarryingFalconTouchTest, CarriesNothingAfterFault)
{
  Servo servo(this->Device, ServoSettings());
  this->Press(servo, 3.0);
  ASSERT_GT(this->Tick(servo).ForceDevice.Y, 0.9 * Weight);
  servo.SwitchOff();
  for (int n = 0; n < 100; ++n)
  {
    const TouchState state = this->Tick(servo);
    ASSERT_EQ(Vector3(state.ForceDevice), Vector3::Zero());
    ASSERT_TRUE(n < 2 || !this->HasTorque()) << n;
  }
}

TEST_F(CarryingFalconTouchTest, WeightAndContactRespectForceLimit)
{
  Servo servo(this->Device, ServoSettings());
  // Far into a wall of 1 N/mm: more than the motors can produce.
  this->Press(servo, 60.0);
  const TouchState state = this->Tick(servo);
  ASSERT_EQ(state.Safety.Fault, SafetyFault::None) << Describe(state.Safety.Fault);
  EXPECT_TRUE(state.Safety.IsLimited);
  EXPECT_LE(Vector3(state.ForceDevice).norm(), this->Device.Capabilities().MaximumForce);
}
} // namespace
} // namespace palpate::falcon_touch_test
