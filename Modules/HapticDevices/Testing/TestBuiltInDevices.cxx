#include "OpenBuiltInDevice.h"

#include "DeviceContract.h"
#include "ManualClock.h"
#include "RecordedSession.h"
#include "TemporaryFolder.h"

namespace palpate::built_in_devices_test
{
namespace
{
TEST(BuiltInDevices, NamesHaveDescriptions)
{
  DeviceRegistry registry;
  ASSERT_TRUE(RegisterBuiltInDevices(registry).IsOk());
  EXPECT_FALSE(registry.Kinds().empty());
  for (const DeviceRegistry::Kind& kind : registry.Kinds())
  {
    EXPECT_FALSE(kind.Description.empty()) << kind.Name;
  }
}

TEST(BuiltInDevices, KeepDeviceContract)
{
  const test::TemporaryFolder folder;
  const std::string session = (folder / "session.touch").string();
  test::RecordSession(session, 400);
  DeviceRegistry registry;
  ASSERT_TRUE(RegisterBuiltInDevices(registry).IsOk());
  for (const DeviceRegistry::Kind& kind : registry.Kinds())
  {
    if (kind.FindDevices)
    {
      continue; // must be plugged in; its own tests check the contract
    }
    SCOPED_TRACE(kind.Name);
    ManualClock clock(5'000'000);
    std::unique_ptr<HapticDevice> device;
    std::string text = kind.Name;
    text.append(kind.Name == "replay" ? ":" + session : "");
    ASSERT_TRUE(registry.Make(text, clock, device).IsOk());
    test::ExpectDeviceContract(*device, [&] { clock.Advance(1'000'000); });
  }
}

TEST(BuiltInDevices, AreHeardByTheEndingOfTheirName)
{
  std::string name = "replay:a+sound";
  EXPECT_TRUE(TakeSound(name));
  EXPECT_EQ(name, "replay:a");
  EXPECT_FALSE(TakeSound(name));
  name = "+sound";
  EXPECT_FALSE(TakeSound(name)) << "of no device";
  ManualClock clock(1);
  std::unique_ptr<HapticDevice> device;
  ASSERT_TRUE(MakeBuiltInDevice("simulated+sound", clock, device).IsOk());
  EXPECT_EQ(device->Capabilities().Name, "Simulated device");
  EXPECT_FALSE(MakeBuiltInDevice("none+sound", clock, device).IsOk());
}

TEST(BuiltInDevices, RejectSecondRegistration)
{
  DeviceRegistry registry;
  ASSERT_TRUE(RegisterBuiltInDevices(registry).IsOk());
  EXPECT_FALSE(RegisterBuiltInDevices(registry).IsOk());
}
} // namespace
} // namespace palpate::built_in_devices_test
