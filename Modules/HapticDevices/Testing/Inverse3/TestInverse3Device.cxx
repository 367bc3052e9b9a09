#include "Inverse3Device.h"

#include "DeviceContract.h"
#include "SteadyClock.h"
#include "VirtualInverse3.h"

#include <chrono>
#include <thread>

namespace palpate::inverse3_device_test
{
namespace
{
using test::VirtualInverse3;

void WaitAMillisecond()
{
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

class Inverse3Test : public testing::Test
{
protected:
  void Make(const VirtualInverse3& service, const std::string& more = "")
  {
    DeviceRegistry registry;
    ASSERT_TRUE(RegisterInverse3Devices(registry).IsOk());
    ASSERT_TRUE(
        registry.Make("inverse3:" + service.Argument() + more, this->Time, this->Device).IsOk());
  }
  /// Ticks until a condition holds, for some seconds at most.
  template <typename Condition>
  bool TickUntil(const Condition& isTrue, const Vector3& force = Vector3::Zero())
  {
    for (int n = 0; n < 5000; ++n)
    {
      WaitAMillisecond();
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

  SteadyClock Time;
  std::unique_ptr<HapticDevice> Device;
  DeviceSample Sample;
  bool IsRead = false;
};

TEST_F(Inverse3Test, KeepsTheContractOfDevices)
{
  const VirtualInverse3 service;
  this->Make(service);
  test::ExpectDeviceContract(*this->Device, [this] { test::AwaitSample(*this->Device); });
}

TEST_F(Inverse3Test, PlaceTurnAndButtonsComeFromTheService)
{
  VirtualInverse3 service;
  this->Make(service);
  ASSERT_TRUE(this->Device->Open().IsOk());
  ASSERT_TRUE(this->BecomesReady());
  service.MoveTo({0.01, 0.02, 0.03});
  const Vector3 here(10.0, 30.0, -20.0);
  EXPECT_TRUE(
      this->TickUntil([&] { return (Vector3(this->Sample.Position) - here).norm() < 1e-9; }));
  EXPECT_EQ(this->Sample.Buttons, 2u);
  EXPECT_NEAR(this->Sample.Orientation[2], -0.6, 1e-12) << "the service's y is forward";
  EXPECT_NE(service.Handshake().find("arm_front_centered"), std::string::npos);
}

TEST_F(Inverse3Test, ForceReachesTheDeviceByTheNameThatItsVersionTakes)
{
  for (const bool takesVector : {true, false})
  {
    VirtualInverse3::Settings settings;
    settings.TakesVector = takesVector;
    const VirtualInverse3 service(settings);
    this->Make(service);
    ASSERT_TRUE(this->Device->Open().IsOk());
    ASSERT_TRUE(this->BecomesReady()) << this->Device->Problem();
    const Vector3 expected(1.0, -3.0, 2.0);
    EXPECT_TRUE(this->TickUntil(
        [&] { return !service.Forces().empty() && service.Forces().back() == expected; },
        {1.0, 2.0, 3.0}));
    this->Device->Close();
    EXPECT_EQ(service.Forces().back(), Vector3::Zero());
  }
}

TEST_F(Inverse3Test, ForceIsClampedAndLapses)
{
  const VirtualInverse3 service;
  this->Make(service);
  ASSERT_TRUE(this->Device->Open().IsOk());
  ASSERT_TRUE(this->BecomesReady());
  EXPECT_TRUE(
      this->TickUntil([&] { return service.Forces().back().norm() > 4.9; }, {0.0, 0.0, 1e9}));
  for (const Vector3& force : service.Forces())
  {
    EXPECT_LE(force.norm(), 5.0 + 1e-9);
  }
  for (int n = 0; n < 2000 && !service.Forces().back().isZero(0.0); ++n)
  {
    WaitAMillisecond(); // without Apply
  }
  EXPECT_EQ(service.Forces().back(), Vector3::Zero());
}

TEST_F(Inverse3Test, MinverseIsSmallerAndOneOfSeveralIsChosenById)
{
  VirtualInverse3::Settings settings;
  settings.Type = "minverse";
  settings.DeviceCount = 3;
  const VirtualInverse3 service(settings);
  this->Make(service, ",id=04A2");
  ASSERT_TRUE(this->Device->Open().IsOk());
  ASSERT_TRUE(this->BecomesReady());
  EXPECT_EQ(this->Device->Capabilities().Workspace.max().x(), 40.0);
  EXPECT_NE(service.Handshake().find("04A2"), std::string::npos);
  this->Device->Close();
  this->Make(service, ",id=none");
  EXPECT_NE(this->Device->Open().Message().find("names no such Inverse3"), std::string::npos);
}

TEST_F(Inverse3Test, WithoutAServiceItSaysWhatToInstall)
{
  std::string argument;
  {
    const VirtualInverse3 service;
    argument = service.Argument();
  }
  DeviceRegistry registry;
  ASSERT_TRUE(RegisterInverse3Devices(registry).IsOk());
  ASSERT_TRUE(registry.Make("inverse3:" + argument, this->Time, this->Device).IsOk());
  EXPECT_NE(this->Device->Open().Message().find("install the Haply Hub"), std::string::npos);
  EXPECT_EQ(this->Device->State(), DeviceState::Closed);
}

TEST_F(Inverse3Test, OpensAgainAfterTheServiceHasRestarted)
{
  auto service = std::make_unique<VirtualInverse3>();
  this->Make(*service);
  ASSERT_TRUE(this->Device->Open().IsOk());
  ASSERT_TRUE(this->BecomesReady());
  service->SetFault(test::Inverse3Fault::CutOff);
  EXPECT_TRUE(this->TickUntil([this] { return this->Device->State() == DeviceState::Error; }));
  EXPECT_FALSE(this->Device->Problem().empty());
  this->Device->Close();
  service->SetFault(test::Inverse3Fault::None);
  ASSERT_TRUE(this->Device->Open().IsOk());
  EXPECT_TRUE(this->BecomesReady());
}
} // namespace
} // namespace palpate::inverse3_device_test
