#include "FalconKind.h"

#include "ManualClock.h"
#include "TemporaryFolder.h"
#include "VirtualFinder.h"

#include <gtest/gtest.h>

namespace palpate::falcon_kind_test
{
namespace
{
class FalconKindTest : public testing::Test
{
protected:
  FalconKindTest() { EXPECT_TRUE(AddFalconKind(this->Registry, this->Finder).IsOk()); }
  Status Make(const std::string& text)
  {
    return this->Registry.Make(text, this->Time, this->Device);
  }

  ManualClock Time;
  std::shared_ptr<test::VirtualFinder> Finder = std::make_shared<test::VirtualFinder>(Time);
  DeviceRegistry Registry;
  std::unique_ptr<HapticDevice> Device;
};

TEST_F(FalconKindTest, UsesFirstFalconByDefault)
{
  ASSERT_TRUE(this->Make("falcon").IsOk());
  EXPECT_EQ(this->Finder->Asked, "");
  EXPECT_EQ(this->Device->Capabilities().Name, "Novint Falcon");
  EXPECT_EQ(this->Device->State(), DeviceState::Closed);
}

TEST_F(FalconKindTest, AcceptsDeviceAndCalibration)
{
  const test::TemporaryFolder folder;
  ASSERT_TRUE(this->Make("falcon").IsOk());
  const double usual = this->Device->Capabilities().MaximumForce;
  const std::string path = (folder / "falcon.txt").string();
  test::WriteAll(path, "palpate-falcon-calibration 1\ncounts-per-newton-millimeter 13.2\n");
  const Status status = this->Make("falcon:device=1-2.3,calibration=" + path);
  ASSERT_TRUE(status.IsOk()) << status.Message();
  EXPECT_EQ(this->Finder->Asked, "1-2.3");
  // Twice the counts per torque mean half the force of the same motors.
  EXPECT_NEAR(this->Device->Capabilities().MaximumForce, 0.5 * usual, 1e-12);
}

TEST_F(FalconKindTest, UsesNamedFirmware)
{
  ASSERT_TRUE(this->Make("falcon:firmware=/no/such/file").IsOk());
  EXPECT_EQ(this->Device->Open().Message(),
            "/no/such/file, the Falcon's firmware, cannot be opened.");
}

TEST_F(FalconKindTest, ErrorsNameUnknownOption)
{
  EXPECT_EQ(this->Make("falcon:calibration=/no/such/file").Message(),
            "/no/such/file, the Falcon's calibration, cannot be opened.");
  for (const std::string word : {"1-2", "port=3", "device=", "=x"})
  {
    const std::string message = "\"" + word + "\" is not understood: a Falcon takes device=, " +
                                "firmware= and calibration=, separated by commas.";
    EXPECT_EQ(this->Make("falcon:" + word).Message(), message);
  }
  EXPECT_FALSE(this->Make("falcon:device=1-2,wrong").IsOk());
}
} // namespace
} // namespace palpate::falcon_kind_test
