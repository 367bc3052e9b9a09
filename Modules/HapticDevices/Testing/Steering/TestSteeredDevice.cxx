#include "SteeredDevice.h"

#include "DeviceContract.h"
#include "ManualClock.h"
#include "Servo.h"
#include "TouchDoubles.h"

namespace palpate::steered_device_test
{
namespace
{
/// What a test sets.
class ScriptedSource final : public SteeringSource
{
public:
  explicit ScriptedSource(SteeringInput& input, bool& isThere) : Given(input), IsThere(isThere) {}
  std::string Name() const override { return "scripted stick"; }
  int Buttons() const override { return 2; }
  std::string Problem() const override { return "gone"; }
  Status Open() override
  {
    return this->IsThere ? Status::Success() : Status::Failure("not there");
  }
  void Close() noexcept override {}
  bool Read(SteeringInput& input) noexcept override
  {
    input = this->Given;
    return this->IsThere;
  }

private:
  SteeringInput& Given;
  bool& IsThere;
};

class SteeredDeviceTest : public testing::Test
{
protected:
  const TouchState& Tick(Servo& servo, int count)
  {
    for (int n = 0; n < count; ++n)
    {
      this->Time.Advance(1'000'000);
      TickInfo tick;
      tick.Number = ++this->Ticks;
      tick.Scheduled = tick.Started = tick.BootTime = this->Time.Now();
      servo.Tick(tick);
    }
    return servo.Latest();
  }

  ManualClock Time{1'000'000};
  std::uint64_t Ticks = 0;
  SteeringInput Input;
  bool IsThere = true;
  SteeredDevice Device{this->Time, std::make_unique<ScriptedSource>(this->Input, this->IsThere)};
};

TEST_F(SteeredDeviceTest, KeepsTheContractOfDevices)
{
  test::ExpectDeviceContract(this->Device, [&] { this->Time.Advance(1'000'000); });
}

TEST_F(SteeredDeviceTest, PushesAWallAsHardAsItsStickAndRestsOnRelease)
{
  ASSERT_TRUE(this->Device.Open().IsOk());
  Servo servo(this->Device, {});
  ContactLaw law;
  law.Stiffness = 1.0;
  ASSERT_TRUE(servo.Publish(std::make_shared<TouchScene>(test::WallScene(30.0, law))).IsOk());
  const auto pushed = [&](double deflection)
  {
    this->Input.Push = -deflection * Vector3::UnitZ();
    return Vector3(this->Tick(servo, 2500).ForceWorld).z();
  };
  const double half = pushed(0.5);
  const double full = pushed(1.0);
  EXPECT_GT(half, 0.8);
  EXPECT_GT(full, 1.7 * half);
  // Springs of hand (0.5 N/mm, 8 mm ahead of the hand) against the wall: 4 N and friction.
  EXPECT_NEAR(full, 4.0, 0.4);
  const double released = pushed(0.0);
  EXPECT_LT(released, 0.5) << "no more than friction holds";
  EXPECT_LT(std::abs(Vector3(servo.Latest().ProbeWorld).z() - 30.0), 0.6);
  EXPECT_EQ(servo.Latest().Safety.Fault, SafetyFault::None);
}

TEST_F(SteeredDeviceTest, PoseTurnsAndButtonsArePassedOn)
{
  ASSERT_TRUE(this->Device.Open().IsOk());
  this->Input.Turn = Vector3::UnitY();
  this->Input.Buttons = 5;
  DeviceSample sample;
  for (int n = 0; n <= 1000; ++n)
  {
    this->Time.Advance(1'000'000);
    ASSERT_TRUE(this->Device.Read(sample));
  }
  EXPECT_EQ(sample.Buttons, 5u);
  const Eigen::Map<const Eigen::Quaterniond> turned(sample.Orientation.data());
  EXPECT_NEAR(Eigen::AngleAxisd(turned).angle(), SteeringSettings().FullTurn, 1e-3);
}

TEST_F(SteeredDeviceTest, IsSlowNearASurfaceThatWasToldOnce)
{
  ASSERT_TRUE(this->Device.Open().IsOk());
  this->Input.Push = -Vector3::UnitZ();
  DeviceSample sample;
  std::vector<double> speeds; // mm/s, of every tick
  this->Device.TellDistance(25.0);
  for (int n = 0; n <= 600; ++n)
  {
    const double before = Vector3(sample.Position).z();
    this->Time.Advance(1'000'000);
    ASSERT_TRUE(this->Device.Read(sample));
    speeds.push_back(1000.0 * (before - Vector3(sample.Position).z()));
  }
  // After 0.1 s, when the hand has caught up with what leads it, and at the end.
  EXPECT_GT(speeds[100], 0.9 * SteeringSettings().FullSpeed);
  EXPECT_LT(speeds.back(), 0.5 * SteeringSettings().FullSpeed);
}

TEST_F(SteeredDeviceTest, UnpluggingFaultsWithinATick)
{
  ASSERT_TRUE(this->Device.Open().IsOk());
  Servo servo(this->Device, {});
  ContactLaw law;
  law.Stiffness = 1.0;
  ASSERT_TRUE(servo.Publish(std::make_shared<TouchScene>(test::WallScene(40.0, law))).IsOk());
  this->Tick(servo, 600);
  ASSERT_GT(Vector3(servo.Latest().ForceWorld).norm(), 0.0);
  this->IsThere = false;
  const TouchState& state = this->Tick(servo, 1);
  EXPECT_EQ(Vector3(state.ForceDevice), Vector3::Zero());
  EXPECT_EQ(state.Safety.Fault, SafetyFault::DeviceFailed);
  EXPECT_EQ(this->Device.State(), DeviceState::Error);
  EXPECT_EQ(this->Device.Problem(), "gone");
  this->Device.Close();
  EXPECT_FALSE(this->Device.Open().IsOk());
  this->IsThere = true;
  EXPECT_TRUE(this->Device.Open().IsOk());
}
} // namespace
} // namespace palpate::steered_device_test
