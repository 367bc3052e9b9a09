#include "Inverse3Address.h"

#include <gtest/gtest.h>

namespace palpate::inverse3_address_test
{
namespace
{
TEST(Inverse3Address, NamesADeviceAndPorts)
{
  Inverse3Address address;
  ASSERT_TRUE(Inverse3Address::Parse("", address).IsOk());
  EXPECT_EQ(address.Port, 10001);
  EXPECT_EQ(address.EventPort, 10020);
  ASSERT_TRUE(Inverse3Address::Parse("049D", address).IsOk());
  EXPECT_EQ(address.Id, "049D");
  ASSERT_TRUE(Inverse3Address::Parse("port=5,id=A,events=6", address).IsOk());
  EXPECT_EQ(address.Id, "A");
  EXPECT_EQ(address.Port, 5);
  EXPECT_EQ(address.EventPort, 6);
}

TEST(Inverse3Address, RefusesWhatIsNone)
{
  Inverse3Address address;
  for (const char* text :
       {"port=0", "port=65536", "port=x", "host=other", "id=", "049D,", ",049D,,"})
  {
    const Status status = Inverse3Address::Parse(text, address);
    EXPECT_EQ(status.IsOk(), std::string(text) == "049D,") << text;
  }
}
} // namespace
} // namespace palpate::inverse3_address_test
