#include "DeviceRegistry.h"

#include "ManualClock.h"

#include <gtest/gtest.h>

namespace palpate::device_registry_test
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
  ASSERT_EQ(registry.Kinds().size(), 2U);
  EXPECT_EQ(registry.Kinds()[0].Name, "first");
  EXPECT_EQ(registry.Kinds()[1].Name, "second");
  ASSERT_NE(registry.Find("second"), nullptr);
  EXPECT_EQ(registry.Find("second")->Description, "two");
  EXPECT_EQ(registry.Find("third"), nullptr);
  ManualClock clock;
  std::unique_ptr<HapticDevice> device;
  EXPECT_EQ(registry.Make("third", clock, device).Message(),
            "There is no kind of device named third; known are: first, second.");
}

TEST(DeviceRegistry, KeepsTheSearchOfAKind)
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
  std::vector<FoundDevice> found;
  EXPECT_TRUE(registry.Find("plugged")->FindDevices(clock, found).IsOk());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].Argument, "1-2");
  EXPECT_FALSE(registry.Find("computed")->FindDevices);
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
} // namespace palpate::device_registry_test
