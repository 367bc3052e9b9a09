#include "FalconCalibration.h"

#include "TemporaryFolder.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>

namespace palpate::falcon_calibration_test
{
namespace
{
const std::string Head = "palpate-falcon-calibration 1\n";
const std::string AllNumbers =
    Head +
    "thigh 60\nshin 102.5\nknee-offset 11.25\nankle-offset 11.25\nplatform-radial 14.43\n"
    "platform-tangential -25\nbase-radial 36.6\nbase-tangential -23.09\nleg-direction-1 105\n"
    "leg-direction-2 -15\nleg-direction-3 -135\nhome-angle-1 35\nhome-angle-2 40\n"
    "home-angle-3 35\nangle-per-count 0.0364\nmiddle-height 125\nlowest-angle -30\n"
    "highest-angle 95\ncounts-per-newton-millimeter 7.1\ncarried-mass 0.09\n";

std::string FaultOf(const std::string& text)
{
  FalconCalibration calibration;
  calibration.CarriedMass = 0.125;
  const Status status = ParseCalibration(text, "file", calibration);
  EXPECT_TRUE(status.IsOk() || calibration.CarriedMass == 0.125)
      << "a refused file must change nothing";
  return status.Message();
}

TEST(FalconCalibration, DefaultsAreValid)
{
  EXPECT_TRUE(Check(FalconCalibration()).IsOk());
}

TEST(FalconCalibration, ReadsEveryNumber)
{
  const test::TemporaryFolder folder;
  test::WriteAll(folder / "a.txt", AllNumbers);
  FalconCalibration read;
  ASSERT_TRUE(ReadCalibration((folder / "a.txt").string(), read).IsOk());
  EXPECT_EQ(read.Geometry.BaseRadial, 36.6);
  EXPECT_NEAR(read.Geometry.HomeAngles[1], 40.0 * M_PI / 180.0, 1e-15);
  EXPECT_NEAR(read.Geometry.HighestAngle, 95.0 * M_PI / 180.0, 1e-15);
  EXPECT_EQ(read.CountsPerNewtonMillimeter, 7.1);
  EXPECT_EQ(read.CarriedMass, 0.09);
}

TEST(FalconCalibration, OmittedNumbersKeepDefaults)
{
  FalconCalibration read;
  ASSERT_TRUE(
      ParseCalibration(Head + "# measured\n\n  shin 102 # mm\nhome-angle-3 40\n", "file", read)
          .IsOk());
  EXPECT_EQ(read.Geometry.Shin, 102.0);
  EXPECT_EQ(read.Geometry.Thigh, 60.0);
  EXPECT_NEAR(read.Geometry.HomeAngles[2], 40.0 * M_PI / 180.0, 1e-15);
}

TEST(FalconCalibration, ReportsEachFault)
{
  const std::string begin = "file is not a Falcon's calibration: ";
  EXPECT_EQ(FaultOf("shin 100\n"),
            begin + "its first line is not \"palpate-falcon-calibration 1\".");
  EXPECT_EQ(FaultOf(Head + "leg 100\n"), begin + "leg is not known.");
  for (const char* const value : {"", "long", "1 2", "1,5", "nan", "inf", "1e999", "0x10"})
  {
    EXPECT_EQ(FaultOf(std::string(Head).append("shin ").append(value)),
              begin + "shin is not followed by one number.")
        << value;
  }
  EXPECT_EQ(FaultOf(Head + "shin -5\n"), "file cannot be used: A Falcon's lengths, its angle per "
                                         "count and its torque scale must be positive numbers.");
  EXPECT_EQ(FaultOf(Head + "shin 5\n"),
            "file cannot be used: With these lengths a Falcon's legs do not reach its middle.");
  EXPECT_EQ(FaultOf(Head + "carried-mass 90\n"),
            "file cannot be used: The mass that a Falcon carries must be from 0 to below 1 kg.");
  FalconCalibration calibration;
  // An endless file.
  EXPECT_EQ(ReadCalibration("/dev/zero", calibration).Message(),
            "/dev/zero is not a Falcon's calibration: it is too long.");
  EXPECT_EQ(ReadCalibration("/no/such", calibration).Message(),
            "/no/such, the Falcon's calibration, cannot be opened.");
}

TEST(FalconCalibration, ParserSurvivesRandomText)
{
  std::mt19937_64 random(71);
  for (int round = 0; round < 5000; ++round)
  {
    std::string text = AllNumbers;
    for (std::size_t faults = 1 + random() % 3; faults > 0; --faults)
    {
      text[random() % text.size()] = static_cast<char>(random());
    }
    FaultOf(text.substr(0, random() % (2 * text.size())));
  }
}
} // namespace
} // namespace palpate::falcon_calibration_test
