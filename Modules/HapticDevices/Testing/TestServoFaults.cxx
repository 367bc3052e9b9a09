// Every fault ends in 0 N and 0 N mm within two ticks, is named, and persists until it is rearmed.
#include "SimulatedTouch.h"

#include <functional>
#include <string>

namespace palpate::servo_faults_test
{
namespace
{
// A rig that presses 3 mm into a wall 10 mm below the origin, which also turns it.
struct Rig
{
  explicit Rig(bool hasMotors)
      : Touch(test::WallScene(-10.0, {1.0, 0.001}, this->Wall), Pressing(hasMotors))
  {
    this->Wall->Arm = 4.0;
  }

  static SimulatedSettings Pressing(bool hasMotors)
  {
    SimulatedSettings device;
    device.HasMotors = hasMotors;
    device.MaximumTorque = 200.0;
    device.Path = [](double) { return Vector3(0.0, 0.0, -13.0); };
    return device;
  }

  std::shared_ptr<test::WallControl> Wall = std::make_shared<test::WallControl>();
  test::SimulatedTouch Touch;
};

struct FaultCase
{
  std::string Name;
  SafetyFault Expected;
  std::function<void(Rig&)> Break;
  std::function<void(Rig&)> Mend;
};

void PrintTo(const FaultCase& c, std::ostream* stream)
{
  *stream << c.Name;
}

FaultCase OfDevice(const std::string& name, SimulatedFault fault, SafetyFault expected)
{
  return {name, expected, [fault](Rig& rig) { rig.Touch.Device.Inject(fault); },
          [](Rig& rig)
          {
            rig.Touch.Device.Inject(SimulatedFault::None);
            if (rig.Touch.Device.State() == DeviceState::Error)
            {
              rig.Touch.Device.Close();
              EXPECT_TRUE(rig.Touch.Device.Open().IsOk());
            }
          }};
}

FaultCase OfScene(const std::string& name, test::WallFault fault)
{
  return {name, SafetyFault::InvalidContact, [fault](Rig& rig) { rig.Wall->Fault = fault; },
          [](Rig& rig) { rig.Wall->Fault = test::WallFault::None; }};
}

std::vector<FaultCase> AllFaults()
{
  return {OfDevice("NonFinitePosition", SimulatedFault::NonFinitePosition,
                   SafetyFault::NonFinitePosition),
          OfDevice("FrozenSample", SimulatedFault::FrozenSample, SafetyFault::StaleSample),
          OfDevice("LateSamples", SimulatedFault::LateSamples, SafetyFault::StaleSample),
          OfDevice("MirroredPosition", SimulatedFault::MirroredPosition,
                   SafetyFault::ImplausibleMotion),
          OfDevice("RefusedForce", SimulatedFault::RefusedForce, SafetyFault::UntakenForce),
          OfDevice("Unplugged", SimulatedFault::Unplugged, SafetyFault::DeviceFailed),
          {"Closed", SafetyFault::DeviceFailed, [](Rig& rig) { rig.Touch.Device.Close(); },
           [](Rig& rig) { EXPECT_TRUE(rig.Touch.Device.Open().IsOk()); }},
          {"StalledTick", SafetyFault::StalledTick,
           [](Rig& rig) { rig.Touch.Time.Advance(15'000'000); }, [](Rig&) {}},
          {"Suspended", SafetyFault::Suspended,
           [](Rig& rig) { rig.Touch.Time.Suspend(3'600'000'000'000); }, [](Rig&) {}},
          {"SwitchedOff", SafetyFault::SwitchedOff, [](Rig& rig) { rig.Touch.Loop.SwitchOff(); },
           [](Rig&) {}},
          OfScene("InvalidContact", test::WallFault::Invalid),
          OfScene("NaNProxy", test::WallFault::NaNProxy),
          OfScene("InfiniteProxy", test::WallFault::InfiniteProxy),
          OfScene("HugeDepth", test::WallFault::HugeDepth),
          OfScene("NaNNormal", test::WallFault::NaNNormal),
          OfScene("NoNormal", test::WallFault::NoNormal)};
}

class ServoFaults : public testing::TestWithParam<FaultCase>
{
protected:
  void SetUp() override
  {
    ASSERT_GT(this->Broken.Touch.Tick(1000).ForceDevice.Z, 0.5);
    ASSERT_GT(this->Broken.Touch.Loop.Latest().TorqueDevice.X, 2.0);
    ASSERT_TRUE(this->Broken.Touch.Loop.Latest().Safety.IsArmed);
  }
  Rig Broken{true};
};

TEST_P(ServoFaults, EndInZeroForceWithinTwoTicks)
{
  GetParam().Break(this->Broken);
  this->Broken.Touch.Tick();
  for (int n = 0; n < 50; ++n)
  {
    const TouchState& state = this->Broken.Touch.Tick();
    ASSERT_EQ(Vector3(state.ForceDevice), Vector3::Zero());
    ASSERT_EQ(Vector3(state.ForceWorld), Vector3::Zero());
    ASSERT_EQ(Vector3(state.TorqueDevice), Vector3::Zero());
    ASSERT_EQ(state.Safety.Fault, GetParam().Expected) << Describe(state.Safety.Fault);
    ASSERT_FALSE(state.Safety.IsArmed);
  }
}

TEST_P(ServoFaults, PersistUntilFixedAndRearmed)
{
  GetParam().Break(this->Broken);
  this->Broken.Touch.Tick(3);
  GetParam().Mend(this->Broken);
  EXPECT_EQ(Vector3(this->Broken.Touch.Tick(2000).ForceDevice), Vector3::Zero());
  this->Broken.Touch.Loop.Rearm();
  EXPECT_EQ(this->Broken.Touch.Tick().Safety.Fault, SafetyFault::None);
  // Fades in, without a step.
  EXPECT_LT(this->Broken.Touch.Tick(5).ForceDevice.Z, 0.2);
  EXPECT_GT(this->Broken.Touch.Tick(1000).ForceDevice.Z, 0.5);
}

INSTANTIATE_TEST_SUITE_P(All, ServoFaults, testing::ValuesIn(AllFaults()),
                         [](const auto& chosen) { return chosen.param.Name; });

// Faults that persist after their first tick.
std::vector<FaultCase> LastingFaults()
{
  std::vector<FaultCase> lasting;
  for (const FaultCase& c : AllFaults())
  {
    if (c.Expected != SafetyFault::StalledTick && c.Expected != SafetyFault::ImplausibleMotion &&
        c.Expected != SafetyFault::Suspended && c.Expected != SafetyFault::SwitchedOff)
    {
      lasting.push_back(c);
    }
  }
  return lasting;
}

class LastingServoFaults : public ServoFaults
{
};

TEST_P(LastingServoFaults, ReturnWithinTwoTicksIfNotFixed)
{
  GetParam().Break(this->Broken);
  this->Broken.Touch.Tick(3);
  this->Broken.Touch.Loop.Rearm();
  this->Broken.Touch.Tick(2);
  for (int n = 0; n < 20; ++n)
  {
    ASSERT_EQ(Vector3(this->Broken.Touch.Tick().ForceDevice), Vector3::Zero());
    ASSERT_FALSE(this->Broken.Touch.Loop.Latest().Safety.IsArmed);
  }
}

INSTANTIATE_TEST_SUITE_P(All, LastingServoFaults, testing::ValuesIn(LastingFaults()),
                         [](const auto& chosen) { return chosen.param.Name; });

class ServoFaultsWithoutMotors : public ServoFaults
{
protected:
  void SetUp() override
  {
    ASSERT_FALSE(this->Mouse.Touch.Device.Capabilities().HasMotors);
    ASSERT_GT(this->Mouse.Touch.Tick(1000).ForceDevice.Z, 0.5);
  }
  Rig Mouse{false};
};

TEST_P(ServoFaultsWithoutMotors, EndInZeroForceAndEndByThemselvesIfOfTiming)
{
  GetParam().Break(this->Mouse);
  this->Mouse.Touch.Tick();
  for (int n = 0; n < 250; ++n)
  {
    ASSERT_EQ(Vector3(this->Mouse.Touch.Tick().ForceDevice), Vector3::Zero()) << n;
  }
  EXPECT_EQ(this->Mouse.Touch.Loop.Latest().Safety.Fault, GetParam().Expected);
  GetParam().Mend(this->Mouse);
  const SafetyFault fault = GetParam().Expected;
  const bool isOfTiming = fault == SafetyFault::StalledTick || fault == SafetyFault::StaleSample ||
                          fault == SafetyFault::Suspended;
  double last = 0.0;
  for (int n = 0, armed = 0; n < 2000; ++n)
  {
    const TouchState& state = this->Mouse.Touch.Tick();
    last = state.ForceDevice.Z;
    armed += state.Safety.IsArmed ? 1 : 0;
    ASSERT_TRUE(armed > 5 || last < 0.2) << n; // fades in, without a step
  }
  EXPECT_EQ(this->Mouse.Touch.Loop.Latest().Safety.IsArmed, isOfTiming);
  EXPECT_EQ(last > 0.5, isOfTiming);
  EXPECT_TRUE(isOfTiming || last == 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, ServoFaultsWithoutMotors, testing::ValuesIn(AllFaults()),
                         [](const auto& chosen) { return chosen.param.Name; });

// What was touched stays touched: the hand is tracked through the fault.
TEST(ServoWithoutMotors, ContactCarriesOnAfterALateTick)
{
  Rig mouse(false);
  mouse.Touch.Tick(1000);
  const int questions = mouse.Wall->Questions;
  mouse.Touch.Time.Advance(15'000'000);
  mouse.Touch.Tick(1000);
  EXPECT_TRUE(mouse.Touch.Loop.Latest().Safety.IsArmed);
  EXPECT_EQ(mouse.Wall->Questions, questions + 1000); // a start would ask twice
}

TEST(ServoWithoutMotors, DrillStaysOffAfterALateTickUntilPressedAgain)
{
  Rig mouse(false);
  mouse.Touch.Loop.RunDrill(true);
  EXPECT_TRUE(mouse.Touch.Tick(1000).IsDrilling);
  mouse.Touch.Time.Advance(15'000'000);
  mouse.Touch.Tick(1000);
  EXPECT_TRUE(mouse.Touch.Loop.Latest().Safety.IsArmed);
  EXPECT_FALSE(mouse.Touch.Loop.Latest().IsDrilling);
}

TEST(ServoBeforeReady, NoForceWhileDeviceHomes)
{
  SimulatedSettings device = Rig::Pressing(true);
  device.HomingDuration = 0.1;
  test::SimulatedTouch touch(test::WallScene(-10.0, {1.0, 0.0}), device);
  for (int n = 0; n < 100; ++n)
  {
    ASSERT_EQ(Vector3(touch.Tick().ForceDevice), Vector3::Zero());
  }
  EXPECT_GT(touch.Tick(1000).ForceDevice.Z, 0.5);
  EXPECT_EQ(touch.Loop.Latest().Safety.Fault, SafetyFault::None);
}
} // namespace
} // namespace palpate::servo_faults_test
