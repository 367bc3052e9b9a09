#include "VendorDevice.h"

#include "DeviceContract.h"
#include "Servo.h"
#include "StandIn.h"
#include "SteadyClock.h"
#include "TouchDoubles.h"

#include <chrono>
#include <cstdlib>
#include <dlfcn.h>
#include <thread>

namespace palpate::vendor_device_test
{
namespace
{
struct Maker
{
  const char* Kind;
  const char* Variable;
  const char* Library;
  Vector3 Place; ///< of the library, which is 10, 20, 30 mm here
  Vector3 Force; ///< of the library, for 1, 2, 0.5 N here
  double Limit;  ///< N
};

/// Each maker's library is replaced by a stand-in, which is opened as the real one would be.
class VendorDeviceTest : public testing::TestWithParam<Maker>
{
protected:
  void SetUp() override
  {
    setenv(this->GetParam().Variable, this->GetParam().Library, 1);
    void* const library = dlopen(this->GetParam().Library, RTLD_NOW);
    ASSERT_NE(library, nullptr) << dlerror();
    this->Arm = static_cast<StandInArm*>(dlsym(library, "StandIn"));
    ASSERT_NE(this->Arm, nullptr);
    this->Arm->IsMissing = false;
    this->Arm->Fails = false;
    this->Arm->LargestForce = 0.0;
    this->Arm->Buttons = 0;
    ASSERT_TRUE(RegisterVendorDevices(this->Registry).IsOk());
    ASSERT_TRUE(this->Registry.Make(this->GetParam().Kind, this->Time, this->Device).IsOk());
  }
  void TearDown() override
  {
    this->Device.reset();
    unsetenv(this->GetParam().Variable);
  }
  template <typename Condition>
  bool TickUntil(const Condition& isTrue, const Vector3& force = Vector3::Zero())
  {
    for (int n = 0; n < 3000; ++n)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      this->IsRead = this->Device->Read(this->Sample);
      this->Device->Apply(force);
      if (isTrue())
      {
        return true;
      }
    }
    return false;
  }
  bool BecomesReady()
  {
    return this->TickUntil([this] { return this->Device->State() == DeviceState::Ready; });
  }
  Vector3 Displayed() const
  {
    return {this->Arm->Force[0], this->Arm->Force[1], this->Arm->Force[2]};
  }

  SteadyClock Time;
  DeviceRegistry Registry;
  std::unique_ptr<HapticDevice> Device;
  StandInArm* Arm = nullptr;
  DeviceSample Sample;
  bool IsRead = false;
};

TEST_P(VendorDeviceTest, KeepsTheContractOfDevices)
{
  test::ExpectDeviceContract(*this->Device, [this] { test::AwaitSample(*this->Device); });
  EXPECT_FALSE(this->Arm->IsOpen);
}

TEST_P(VendorDeviceTest, PlaceTurnAndForceAreInThisProgramsFrame)
{
  for (int part = 0; part < 3; ++part)
  {
    this->Arm->Place[part] = this->GetParam().Place[part];
  }
  this->Arm->Buttons = 2;
  ASSERT_TRUE(this->Device->Open().IsOk());
  ASSERT_TRUE(this->BecomesReady());
  EXPECT_TRUE(this->TickUntil([this] { return this->Displayed() == this->GetParam().Force; },
                              {1.0, 2.0, 0.5}));
  EXPECT_LT((Vector3(this->Sample.Position) - Vector3(10.0, 20.0, 30.0)).norm(), 1e-9);
  EXPECT_EQ(this->Sample.Buttons, 2u);
  const double half = std::sqrt(0.5);
  // OpenHaptics: about z; Force Dimension: about its own z, which is y here.
  const bool isAboutZ = std::string(this->GetParam().Kind) == "openhaptics";
  EXPECT_NEAR(this->Sample.Orientation[isAboutZ ? 2 : 1], half, 1e-12);
  EXPECT_NEAR(this->Sample.Orientation[3], half, 1e-12);
}

TEST_P(VendorDeviceTest, ForceIsClampedLapsesAndEndsWithTheDevice)
{
  ASSERT_TRUE(this->Device->Open().IsOk());
  ASSERT_TRUE(this->BecomesReady());
  EXPECT_TRUE(this->TickUntil([this] { return this->Displayed().norm() > 1.0; }, {0.0, 1e9, 0.0}));
  EXPECT_LE(this->Arm->LargestForce, this->GetParam().Limit + 1e-9);
  for (int n = 0; n < 2000 && !this->Displayed().isZero(0.0); ++n)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1)); // without Apply
  }
  EXPECT_EQ(this->Displayed(), Vector3::Zero());
  EXPECT_TRUE(this->TickUntil([this] { return this->Displayed().norm() > 1.0; }, {0.0, 2.0, 0.0}));
  this->Device->Close();
  EXPECT_EQ(this->Displayed(), Vector3::Zero());
  EXPECT_FALSE(this->Arm->IsOpen);
}

TEST_P(VendorDeviceTest, FailureOfTheLibraryIsZeroForceInItsStepAndAnError)
{
  ASSERT_TRUE(this->Device->Open().IsOk());
  Servo servo(*this->Device, {});
  ContactLaw law;
  law.Stiffness = 0.5;
  ASSERT_TRUE(servo.Publish(std::make_shared<TouchScene>(test::WallScene(200.0, law))).IsOk());
  std::uint64_t ticks = 0;
  const auto tick = [&]
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    TickInfo now;
    now.Number = ++ticks;
    now.Started = now.Scheduled = this->Time.Now();
    now.BootTime = this->Time.BootTime();
    servo.Tick(now);
  };
  for (int n = 0; n < 5000 && !(this->Displayed().norm() > 1.0); ++n)
  {
    tick();
    if (servo.Latest().Safety.Fault != SafetyFault::None)
    {
      servo.Rearm(); // the machine was late
    }
  }
  ASSERT_GT(this->Displayed().norm(), 1.0);
  this->Arm->Fails = true;
  for (int n = 0; n < 50; ++n)
  {
    tick();
  }
  EXPECT_EQ(servo.Latest().Safety.Fault, SafetyFault::DeviceFailed);
  EXPECT_EQ(this->Device->State(), DeviceState::Error);
  EXPECT_NE(this->Device->Problem().find("open it again"), std::string::npos);
  EXPECT_EQ(this->Displayed(), Vector3::Zero());
  const int steps = this->Arm->Steps;
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(this->Arm->Steps, steps) << "no step after the failure";
}

TEST_P(VendorDeviceTest, WithoutADeviceOrALibraryItSaysWhatToDo)
{
  this->Arm->IsMissing = true;
  EXPECT_FALSE(this->Device->Open().IsOk());
  EXPECT_EQ(this->Device->State(), DeviceState::Closed);
  setenv(this->GetParam().Variable, "/no/such/library.so", 1);
  EXPECT_NE(this->Device->Open().Message().find("is not installed"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Each, VendorDeviceTest,
    testing::Values(Maker{"openhaptics", "PALPATE_LIBHD", PALPATE_STAND_IN_HD,
                          Vector3(10.0, 20.0, 30.0), Vector3(1.0, 2.0, 0.5), 7.9},
                    Maker{"forcedimension", "PALPATE_LIBDHD", PALPATE_STAND_IN_DHD,
                          Vector3(0.030, 0.010, 0.020), Vector3(0.5, 1.0, 2.0), 8.0}),
    [](const auto& tested) { return std::string(tested.param.Kind); });
} // namespace
} // namespace palpate::vendor_device_test
