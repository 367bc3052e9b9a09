#include "ScreenText.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::screen_text_test
{
namespace
{
TEST(ScreenText, KeepsLettersOfEveryLanguage)
{
  for (const char* text : {"Prostate 2", "Pankreas-K\u00f6rper", "\u524d\u7acb\u817a",
                           "\u05d1\u05dc\u05d5\u05d8\u05d4", "\U0001F9E0"})
  {
    EXPECT_EQ(Printable(text), text);
  }
}

TEST(ScreenText, EscapesControlsLineBreaksAndInvisibles)
{
  EXPECT_EQ(Printable("a\nb\tc\x1b[31m"), "a\\x0ab\\x09c\\x1b[31m");
  EXPECT_EQ(Printable("\u0085"), "\\xc2\\x85");
  EXPECT_EQ(Printable("\u2028"), "\\xe2\\x80\\xa8");
  EXPECT_EQ(Printable("gpj.\u202ecod.exe"), "gpj.\\xe2\\x80\\xaecod.exe");
  for (const char* hidden : {"\u061c", "\u200b", "\u200e", "\u2066", "\ufeff", "\U000E0041"})
  {
    EXPECT_EQ(Printable(hidden).substr(0, 2), "\\x") << hidden;
  }
}

TEST(ScreenText, EscapesInvalidUtf8)
{
  EXPECT_EQ(Printable("\xff"), "\\xff");
  EXPECT_EQ(Printable("a\xc3"), "a\\xc3");
  EXPECT_EQ(Printable("\xc3("), "\\xc3(");
  EXPECT_EQ(Printable("\xc0\x8a"), "\\xc0\\x8a") << "a line feed in two bytes";
  EXPECT_EQ(Printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
}

TEST(ScreenText, AnyBytesBecomeOneLine)
{
  std::mt19937 random(5);
  for (int n = 0; n < 20000; ++n)
  {
    std::string text(random() % 9, ' ');
    for (char& byte : text)
    {
      byte = static_cast<char>(random() % 256);
    }
    const std::string shown = Printable(text);
    ASSERT_EQ(Printable(shown), shown);
    for (const char byte : shown)
    {
      ASSERT_FALSE(static_cast<unsigned char>(byte) < 0x20 || byte == 0x7f);
    }
  }
}
} // namespace
} // namespace palpate::screen_text_test
