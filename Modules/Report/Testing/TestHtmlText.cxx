#include "HtmlText.h"

#include <gtest/gtest.h>

namespace palpate::html_text_test
{
namespace
{
TEST(HtmlText, EscapesMarkupAndQuotes)
{
  EXPECT_EQ(EscapeHtml("<b a=\"1\" b='2'>&amp;"),
            "&lt;b a=&quot;1&quot; b=&#39;2&#39;&gt;&amp;amp;");
}

TEST(HtmlText, KeepsUtf8AndShowsInvalidBytes)
{
  EXPECT_EQ(EscapeHtml("Dr\xC3\xBCse \xF0\x9F\x98\x80"), "Dr\xC3\xBCse \xF0\x9F\x98\x80");
  EXPECT_EQ(EscapeHtml("Dr\xFCse"), "Dr\\xfcse");           // Latin-1
  EXPECT_EQ(EscapeHtml("\xC3"), "\\xc3");                   // cut off
  EXPECT_EQ(EscapeHtml("\xC0\xBC"), "\\xc0\\xbc");          // overlong '<'
  EXPECT_EQ(EscapeHtml("\xED\xA0\x80"), "\\xed\\xa0\\x80"); // surrogate
}

TEST(HtmlText, ShowsControlCharactersAndReplacesLineBreaks)
{
  EXPECT_EQ(EscapeHtml(std::string("a\0b\x01\x1B[31mc\nd\x7F", 13)),
            "a\\x00b\\x01\\x1b[31mc d\\x7f");
  EXPECT_EQ(EscapeHtml("gpj.\u202ecod.exe"), "gpj.\\xe2\\x80\\xaecod.exe");
}

} // namespace
} // namespace palpate::html_text_test
