#include "DeviceOption.h"

#include <gtest/gtest.h>

namespace palpate::device_option_test
{
namespace
{
TEST(DeviceOption, ReplacesEarlierValues)
{
  const auto with = [](const std::string& device)
  { return WithDeviceOption(device, "firmware", "/a=b"); };
  EXPECT_EQ(with("falcon"), "falcon:firmware=/a=b");
  EXPECT_EQ(with("falcon:"), "falcon:firmware=/a=b");
  EXPECT_EQ(with("falcon:device=1-2"), "falcon:device=1-2,firmware=/a=b");
  EXPECT_EQ(with("falcon:firmware=old,device=1-2"), "falcon:device=1-2,firmware=/a=b");
  EXPECT_EQ(with("falcon:firmware=old"), "falcon:firmware=/a=b");
}
} // namespace
} // namespace palpate::device_option_test
