#include "Base64Text.h"

#include "DataUri.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::base64_text_test
{
namespace
{
TEST(Base64Text, InvertsEncoder)
{
  std::mt19937 random(3);
  for (std::size_t length = 0; length < 50; ++length)
  {
    std::string bytes(length, '\0');
    for (char& byte : bytes)
    {
      byte = static_cast<char>(random());
    }
    std::string text = DataUri("", bytes);
    text = text.substr(text.find(',') + 1);
    EXPECT_EQ(DecodedBase64(text), bytes);
    EXPECT_EQ(DecodedBase64("\n " + text + "\r\n\t"), bytes);
  }
}

TEST(Base64Text, DecodesExamplesOfStandard)
{
  EXPECT_EQ(DecodedBase64("Zm9vYmFy"), "foobar");
  EXPECT_EQ(DecodedBase64("Zm9v\nYmE="), "fooba");
  EXPECT_EQ(DecodedBase64("Zg=="), "f");
  EXPECT_EQ(DecodedBase64(""), "");
}

TEST(Base64Text, RejectsOtherTexts)
{
  for (const char* text : {"Z", "Zg", "Zg=", "Zg===", "=", "====", "Z===", "Zg=a",
                           "Zg==Zg==", "Zm9v=", "Zm9v====", "Zm-v", "Zm9\xff"})
  {
    EXPECT_FALSE(DecodedBase64(text).has_value()) << text;
  }
}
} // namespace
} // namespace palpate::base64_text_test
