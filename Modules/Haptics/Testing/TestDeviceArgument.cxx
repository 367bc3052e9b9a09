#include "DeviceArgument.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
TEST(DeviceArgument, SaysWhichAndWithWhatFirmware)
{
  const auto expect = [](const std::string& text, const std::string& which, const std::string& file)
  {
    const DeviceArgument argument = ParseDeviceArgument(text);
    EXPECT_EQ(argument.Which, which) << text;
    EXPECT_EQ(argument.Firmware, file) << text;
  };
  expect("", "", "");
  expect("1-2.3", "1-2.3", "");
  expect("firmware=/a,b=c.bin", "", "/a,b=c.bin");
  expect("1-2,firmware=a.bin", "1-2", "a.bin");
  expect("1-2,firmware=", "1-2", "");
}

TEST(DeviceArgument, FirmwareReplacesWhatWasSaid)
{
  EXPECT_EQ(WithFirmware("falcon", "a.bin"), "falcon:firmware=a.bin");
  EXPECT_EQ(WithFirmware("falcon:1-2", "a.bin"), "falcon:1-2,firmware=a.bin");
  EXPECT_EQ(WithFirmware("falcon:1-2,firmware=old", "a.bin"), "falcon:1-2,firmware=a.bin");
  EXPECT_EQ(WithFirmware("falcon:firmware=old", "a.bin"), "falcon:firmware=a.bin");
}
} // namespace
} // namespace palpate
