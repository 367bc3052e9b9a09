#include "DeviceRegistry.h"

#include "ManualClock.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
Status Refuse(Clock&, const std::string& argument, std::unique_ptr<HapticDevice>&)
{
  return Status::Failure("refused <" + argument + ">");
}

TEST(DeviceRegistry, PassesTheArgumentToTheNamedFactory)
{
  DeviceRegistry registry;
  ASSERT_TRUE(registry.Add("first", "", Refuse).IsOk());
  ManualClock clock;
  std::unique_ptr<HapticDevice> device;
  EXPECT_EQ(registry.Make("first:a:b", clock, device).Message(), "refused <a:b>");
  EXPECT_EQ(registry.Make("first", clock, device).Message(), "refused <>");
}

TEST(DeviceRegistry, ListsKnownNamesForAnUnknownOne)
{
  DeviceRegistry registry;
  ASSERT_TRUE(registry.Add("first", "one", Refuse).IsOk());
  ASSERT_TRUE(registry.Add("second", "two", Refuse).IsOk());
  EXPECT_EQ(registry.Names(), (std::vector<std::string>{"first", "second"}));
  EXPECT_EQ(registry.Description("second"), "two");
  EXPECT_EQ(registry.Description("third"), "");
  ManualClock clock;
  std::unique_ptr<HapticDevice> device;
  EXPECT_EQ(registry.Make("third", clock, device).Message(),
            "There is no kind of device named third; known are: first, second.");
}

TEST(DeviceRegistry, FindsDevicesOfSearchableKinds)
{
  DeviceRegistry registry;
  const auto search = [](Clock&, std::vector<FoundDevice>& found)
  {
    found.push_back({"1-2", true, "closed"});
    return Status::Success();
  };
  ASSERT_TRUE(registry.Add("plugged", "", Refuse, search).IsOk());
  ASSERT_TRUE(registry.Add("computed", "", Refuse).IsOk());
  ManualClock clock;
  std::vector<FoundDevice> found(3);
  EXPECT_TRUE(registry.CanBeFound("plugged"));
  EXPECT_TRUE(registry.FindDevices("plugged", clock, found).IsOk());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].Argument, "1-2");
  for (const char* name : {"computed", "unknown"})
  {
    EXPECT_FALSE(registry.CanBeFound(name));
    EXPECT_FALSE(registry.FindDevices(name, clock, found).IsOk());
    EXPECT_TRUE(found.empty());
  }
}

TEST(DeviceRegistry, RejectsInvalidKinds)
{
  DeviceRegistry registry;
  ASSERT_TRUE(registry.Add("first", "", Refuse).IsOk());
  EXPECT_FALSE(registry.Add("first", "", Refuse).IsOk());
  EXPECT_FALSE(registry.Add("", "", Refuse).IsOk());
  EXPECT_FALSE(registry.Add("a:b", "", Refuse).IsOk());
  EXPECT_FALSE(registry.Add("second", "", nullptr).IsOk());
}
} // namespace
} // namespace palpate
