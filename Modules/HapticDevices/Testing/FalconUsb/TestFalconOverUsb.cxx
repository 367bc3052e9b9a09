#include "FalconOverUsb.h"

namespace palpate::falcon_over_usb_test
{
namespace
{
using test::FalconOverUsb;
using test::UsbfsFalcon;
using test::VirtualFalcon;

TEST_F(FalconOverUsb, LoadsHomesAndPushes)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenAndHome());
  EXPECT_TRUE(this->TickUntil([this] { return this->HasTorque(); }, {0.0, 0.0, 1.0}));
  EXPECT_NEAR(this->Sample.Position.X, 0.0, 0.1);
  // On a busy machine some replies are late.
  EXPECT_GT(this->Device->Statistics().Replies, this->Device->Statistics().Requests / 2)
      << this->Device->ConnectionReport();
  this->Device->Close();
  EXPECT_FALSE(this->HasTorque()) << "closing must remove the force first";
  EXPECT_EQ(this->Bus.FileCount(), 0U);
}

TEST_F(FalconOverUsb, KeepsRunningFirmware)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenAndHome());
  const auto resets = [](VirtualFalcon& falcon) { return falcon.Board().Resets(); };
  EXPECT_EQ(this->Bus.WithFalcon(resets), 1) << "one upload";
  this->Device->Close();
  ASSERT_NO_FATAL_FAILURE(this->OpenAndHome());
  EXPECT_EQ(this->Bus.WithFalcon(resets), 1);
}

TEST_F(FalconOverUsb, RecoversFromUnpluggingByReopening)
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
} // namespace palpate::falcon_over_usb_test
