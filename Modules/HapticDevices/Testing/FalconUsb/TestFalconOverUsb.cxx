#include "BootStream.h"
#include "FalconDevice.h"
#include "FixedRateLoop.h"
#include "ShimmedFalcon.h"
#include "SteadyClock.h"
#include "TemporaryFolder.h"

#include <cmath>

namespace palpate
{
namespace
{
using test::UsbfsFalcon;
using test::VirtualFalcon;

// The whole driver on the real libusb, in real time. A rigid hand pulls the handle out and pushes
// it in twice a second.
class FalconOverUsb : public testing::Test, protected test::ShimmedFalcon
{
protected:
  FalconOverUsb()
  {
    this->Model.Mechanism().Settings.IsRigid = true;
    this->Model.Mechanism().Settings.Path = [](double t)
    { return Vector3(0.0, 0.0, 130.0 - 45.0 * std::cos(4.0 * M_PI * t)); };
    const std::vector<std::uint8_t> image = test::BootStream();
    test::WriteAll(this->Folder / "firmware.bin", {image.begin(), image.end()});
    FalconSettings settings;
    settings.FirmwarePath = (this->Folder / "firmware.bin").string();
    this->Device = std::make_unique<FalconDevice>(
        this->Time, std::make_unique<LibusbFalconLink>([this] { return this->Node.Open(); }),
        settings);
  }

  // Cycles of a servo until something holds, for at most ten seconds.
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

  test::TemporaryFolder Folder;
  SteadyClock Time;
  std::unique_ptr<FalconDevice> Device;
  DeviceSample Sample;
};

TEST_F(FalconOverUsb, IsLoadedAndHomedAndPushes)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenAndHome());
  EXPECT_TRUE(this->TickUntil([this] { return this->HasTorque(); }, {0.0, 0.0, 1.0}));
  EXPECT_NEAR(this->Sample.Position.X, 0.0, 0.1);
  // On a busy machine some come too late.
  EXPECT_GT(this->Device->Statistics().Replies, this->Device->Statistics().Requests / 2)
      << this->Device->ConnectionReport();
  this->Device->Close();
  EXPECT_FALSE(this->HasTorque()) << "closing takes the force away first";
  EXPECT_EQ(this->Bus.FileCount(), 0U);
}

TEST_F(FalconOverUsb, FirmwareThatRunsIsNotLoadedAgain)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenAndHome());
  EXPECT_EQ(this->Device->BootReport().Attempts, 1);
  this->Device->Close();
  ASSERT_NO_FATAL_FAILURE(this->OpenAndHome());
  EXPECT_EQ(this->Device->BootReport().Attempts, 0);
}

TEST_F(FalconOverUsb, UnpluggedInContactItFailsAndComesBackByOpeningItAgain)
{
  for (const auto how :
       {UsbfsFalcon::Unplugging::AbortsReads, UsbfsFalcon::Unplugging::RefusesNext})
  {
    ASSERT_NO_FATAL_FAILURE(this->OpenAndHome());
    ASSERT_TRUE(this->TickUntil([this] { return this->HasTorque(); }, {0.0, 0.0, 1.0}));
    this->Bus.Unplug(how);
    EXPECT_TRUE(this->TickUntil([this] { return this->Device->State() == DeviceState::Error; }));
    EXPECT_EQ(this->Device->Problem(), "The Falcon was unplugged: plug it in and open it again.");
    EXPECT_FALSE(this->Device->Read(this->Sample));
    EXPECT_FALSE(this->Device->Apply({0.0, 0.0, 1.0}));
    this->Device->Close();
    EXPECT_FALSE(this->Device->Open().IsOk());
    this->Bus.Plug();
  }
  ASSERT_NO_FATAL_FAILURE(this->OpenAndHome());
}
} // namespace
} // namespace palpate
