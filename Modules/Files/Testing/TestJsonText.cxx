#include "JsonText.h"
#include "MessageOf.h"
#include "ModelFile.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

namespace palpate::json_text_test
{
namespace
{
using namespace palpate::test;

std::string Nested(std::size_t depth)
{
  return std::string(depth, '[') + std::string(depth, ']');
}

std::string Refusal(const std::string& text)
{
  return MessageOf([&] { ParseJson(text, "a.json", "mend it"); });
}

TEST(JsonText, RejectsDeepNesting)
{
  EXPECT_EQ(Refusal(Nested(64)), "no error");
  EXPECT_EQ(Refusal(Nested(65)),
            "a.json cannot be read: its JSON is nested more than 64 deep; mend it.");
  EXPECT_TRUE(Contains(Refusal(Nested(10000000)), "nested more than 64 deep"));
  std::string objects;
  for (int level = 0; level < 100000; ++level)
  {
    objects += "{\"a\":";
  }
  EXPECT_TRUE(Contains(Refusal(objects), "nested more than 64 deep"));
}

TEST(JsonText, BracketsInStringsDoNotCountAsDepth)
{
  const std::string text = "[\"" + std::string(100, '[') + "\\\"" + std::string(100, '{') + "\"]";
  EXPECT_EQ(ParseJson(text, "a.json", "mend it")[0].get<std::string>().size(), 201U);
  const auto listsInARow = "[" + std::string("[],") + std::string("[]]");
  EXPECT_EQ(ParseJson(listsInARow, "a.json", "mend it").size(), 2U);
}

TEST(JsonText, RejectsInvalidJsonWithPosition)
{
  EXPECT_EQ(Refusal("{\n  \"a\": nonsense\n}"),
            "a.json is not valid JSON at line 2, column 9; mend it.");
  EXPECT_TRUE(Contains(Refusal(""), "is not valid JSON"));
  EXPECT_TRUE(Contains(Refusal("[1e999]"), "a number that is too large"));
}

TEST(JsonText, BoundsOrderedObjects)
{
  std::string text = "{";
  for (int key = 0; key < 200000; ++key)
  {
    text += "\"" + std::to_string(key) + "\":0,";
  }
  text.back() = '}';
  EXPECT_TRUE(Contains(MessageOf([&] { ParseOrderedJson(text, "a.json", "mend it"); }),
                       "more than 10000 keys"));
}

TEST(JsonText, RejectsDeeplyNestedModel)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.json", "{\"format\": " + Nested(1000000) + "}");
  EXPECT_TRUE(Contains(MessageOf([&] { ReadModel(folder / "a.json"); }), "64 deep"));
}
} // namespace
} // namespace palpate::json_text_test
