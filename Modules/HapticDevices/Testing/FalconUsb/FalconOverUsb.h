#pragma once

#include "BootStream.h"
#include "FalconDevice.h"
#include "FixedRateLoop.h"
#include "ShimmedFalcon.h"
#include "SteadyClock.h"
#include "TemporaryFolder.h"

#include <cmath>

namespace palpate::test
{
/// The whole driver on the real libusb, in real time. A rigid hand pulls the handle out and pushes
/// it in twice a second.
class FalconOverUsb : public testing::Test, protected ShimmedFalcon
{
protected:
  FalconOverUsb()
  {
    this->Model.Mechanism().Settings.IsRigid = true;
    this->Model.Mechanism().Settings.Path = [](double t)
    { return Vector3(0.0, 0.0, 130.0 - 45.0 * std::cos(4.0 * M_PI * t)); };
    const std::vector<std::uint8_t> image = BootStream();
    WriteAll(this->Folder / "firmware.bin", {image.begin(), image.end()});
    FalconSettings settings;
    settings.FirmwarePath = (this->Folder / "firmware.bin").string();
    this->Device = std::make_unique<FalconDevice>(
        this->Time, std::make_unique<LibusbFalconLink>([this] { return this->Node.Open(); }),
        settings);
  }

  // Runs servo cycles until a condition holds, for at most ten seconds.
  template <typename Condition>
  bool TickUntil(const Condition& condition, const Vector3& force = Vector3::Zero())
  {
    constexpr std::int64_t Period = 1'000'000; // ns
    constexpr std::uint64_t Patience = 10'000; // ticks
    bool holds = false;
    FixedRateLoop(this->Time, Period)
        .Run(
            [&](const TickInfo& tick)
            {
              static_cast<void>(this->Device->Read(this->Sample) && this->Device->Apply(force));
              holds = condition();
              return !holds && tick.Number < Patience;
            });
    return holds;
  }

  void OpenAndHome()
  {
    const Status status = this->Device->Open();
    ASSERT_TRUE(status.IsOk()) << status.Message();
    EXPECT_NE(this->Device->Guidance(), "");
    ASSERT_TRUE(this->TickUntil([this] { return this->Device->State() == DeviceState::Ready; }))
        << this->Device->Problem() << this->Device->Guidance() << '\n'
        << this->Device->ConnectionReport();
    EXPECT_EQ(this->Device->Guidance(), "");
  }

  bool HasTorque()
  {
    return this->Bus.WithFalcon([](VirtualFalcon& falcon) { return falcon.Board().Motors(); }) !=
           std::array<std::int16_t, 3>{};
  }

  TemporaryFolder Folder;
  SteadyClock Time;
  std::unique_ptr<FalconDevice> Device;
  DeviceSample Sample;
};
} // namespace palpate::test
