#include "HtmlText.h"

#include <gtest/gtest.h>

using palpate::EscapeHtml;

TEST(HtmlText, EscapesMarkupAndQuotes)
{
  EXPECT_EQ(EscapeHtml("<b a=\"1\" b='2'>&amp;"),
            "&lt;b a=&quot;1&quot; b=&#39;2&#39;&gt;&amp;amp;");
}

TEST(HtmlText, KeepsUtf8AndReplacesInvalidBytes)
{
  EXPECT_EQ(EscapeHtml("Dr\xC3\xBCse \xF0\x9F\x98\x80"), "Dr\xC3\xBCse \xF0\x9F\x98\x80");
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(EscapeHtml("Dr\xFCse"), "Dr" + replaced + "se");             // Latin-1
  EXPECT_EQ(EscapeHtml("\xC3"), replaced);                               // cut off
  EXPECT_EQ(EscapeHtml("\xC0\xBC"), replaced + replaced);                // overlong '<'
  EXPECT_EQ(EscapeHtml("\xED\xA0\x80"), replaced + replaced + replaced); // surrogate
}

TEST(HtmlText, RemovesControlCharactersAndLineBreaks)
{
  EXPECT_EQ(EscapeHtml(std::string("a\0b\x01\x1B[31mc\nd\x7F", 12)), "ab[31mc d");
}

TEST(HtmlText, TablesEscapeNamesAndValues)
{
  const std::string html = palpate::HtmlTable("<c>", {{"<n>", "<v>"}});
  EXPECT_NE(html.find("&lt;c&gt;"), std::string::npos);
  EXPECT_NE(html.find("&lt;n&gt;"), std::string::npos);
  EXPECT_NE(html.find("&lt;v&gt;"), std::string::npos);
}
