#include "SpaceMouseDevice.h"

#include "DeviceContract.h"
#include "ManualClock.h"
#include "SpaceMouseSource.h"
#include "TemporaryFolder.h"
#include "VirtualSpnav.h"

namespace palpate::space_mouse_device_test
{
namespace
{
class SpaceMouseTest : public testing::Test
{
protected:
  SpaceMouseTest()
  {
    EXPECT_TRUE(RegisterSpaceMouseDevices(this->Registry).IsOk());
    EXPECT_TRUE(this->Registry.Make("spacemouse:" + this->Path, this->Time, this->Device).IsOk());
  }
  DeviceSample After(int milliseconds)
  {
    DeviceSample sample;
    for (int n = 0; n < milliseconds; ++n)
    {
      this->Time.Advance(1'000'000);
      EXPECT_TRUE(this->Device->Read(sample));
    }
    return sample;
  }

  test::TemporaryFolder Folder;
  std::string Path = (Folder / "spnav.sock").string();
  ManualClock Time{1'000'000};
  DeviceRegistry Registry;
  std::unique_ptr<HapticDevice> Device;
};

TEST_F(SpaceMouseTest, KeepsTheContractOfDevices)
{
  const test::VirtualSpnav daemon(this->Path);
  test::ExpectDeviceContract(*this->Device, [&] { this->Time.Advance(1'000'000); });
}

TEST_F(SpaceMouseTest, DeflectionMovesTheHandUntilItIsReleased)
{
  test::VirtualSpnav daemon(this->Path);
  ASSERT_TRUE(this->Device->Open().IsOk());
  daemon.Accept();
  daemon.Send({0, 175, 0, 0, 0, 0, 0, 16});
  daemon.Send({1, 0});
  const DeviceSample moved = this->After(400);
  EXPECT_GT(moved.Position.X, 3.0);
  EXPECT_NEAR(moved.Position.Y, 0.0, 1e-9);
  EXPECT_EQ(moved.Buttons, 1u);
  daemon.Send({0, 0, 0, 0, 0, 0, 0, 16});
  const DeviceSample released = this->After(400);
  const DeviceSample later = this->After(400);
  EXPECT_NEAR(later.Position.X, released.Position.X, 0.1);
}

TEST_F(SpaceMouseTest, EndOfTheDaemonIsAnErrorThatSaysWhatToDo)
{
  test::VirtualSpnav daemon(this->Path);
  ASSERT_TRUE(this->Device->Open().IsOk());
  daemon.Accept();
  this->After(3);
  daemon.End();
  DeviceSample sample;
  EXPECT_FALSE(this->Device->Read(sample));
  EXPECT_EQ(this->Device->State(), DeviceState::Error);
  EXPECT_NE(this->Device->Problem().find("spacenavd"), std::string::npos);
}

TEST_F(SpaceMouseTest, WithoutADaemonItSaysWhatToInstall)
{
  const Status status = this->Device->Open();
  EXPECT_NE(status.Message().find("install and start it"), std::string::npos) << status.Message();
  EXPECT_EQ(this->Device->State(), DeviceState::Closed);
  std::unique_ptr<HapticDevice> tooLong;
  ASSERT_TRUE(
      this->Registry.Make("spacemouse:" + std::string(300, 'x'), this->Time, tooLong).IsOk());
  EXPECT_FALSE(tooLong->Open().IsOk());
}
} // namespace
} // namespace palpate::space_mouse_device_test
