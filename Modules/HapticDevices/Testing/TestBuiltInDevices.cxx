#include "BuiltInDevices.h"

#include "ManualClock.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
TEST(BuiltInDevices, EveryNameHasADescription)
{
  DeviceRegistry registry;
  ASSERT_TRUE(RegisterBuiltInDevices(registry).IsOk());
  EXPECT_FALSE(registry.Names().empty());
  for (const std::string& name : registry.Names())
  {
    EXPECT_FALSE(registry.Description(name).empty()) << name;
  }
}

TEST(BuiltInDevices, ASimulatedDeviceIsMadeClosedAndOpens)
{
  DeviceRegistry registry;
  ASSERT_TRUE(RegisterBuiltInDevices(registry).IsOk());
  ManualClock clock;
  std::unique_ptr<HapticDevice> device;
  ASSERT_TRUE(registry.Make("simulated", clock, device).IsOk());
  EXPECT_EQ(device->State(), DeviceState::Closed);
  EXPECT_TRUE(device->Open().IsOk());
  EXPECT_EQ(device->State(), DeviceState::Ready);
}

TEST(BuiltInDevices, AreNotAddedTwice)
{
  DeviceRegistry registry;
  ASSERT_TRUE(RegisterBuiltInDevices(registry).IsOk());
  EXPECT_FALSE(RegisterBuiltInDevices(registry).IsOk());
}
} // namespace
} // namespace palpate
