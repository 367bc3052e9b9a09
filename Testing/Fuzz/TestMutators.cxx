#include "BinaryFields.h"
#include "GzipMutator.h"
#include "JsonMutator.h"
#include "SyntheticImages.h"
#include "TextMutator.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::test::mutators_test
{
namespace
{
constexpr int Rounds = 2000;

template <typename Look>
void ForEachMutated(const std::string& seed, const Mutator& mutate, const Look& look)
{
  Random random(11);
  for (int round = 0; round < Rounds; ++round)
  {
    std::string bytes = seed;
    mutate(bytes, random);
    look(bytes);
  }
}

std::size_t Deepest(const std::string& text, char open, char close)
{
  std::size_t depth = 0;
  std::size_t deepest = 0;
  for (const char sign : text)
  {
    depth += sign == open ? 1 : 0;
    depth -= sign == close && depth > 0 ? 1 : 0;
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

TEST(FieldMutator, ChangesOnlyItsFields)
{
  const std::string seed(16, '\1');
  int changed = 0;
  ForEachMutated(seed, FieldMutator({{4, 2}, {8, 4, BinaryField::Type::Real}, {15, 4}}),
                 [&](const std::string& bytes)
                 {
                   ASSERT_EQ(bytes.size(), seed.size());
                   EXPECT_EQ(bytes.substr(0, 4) + bytes.substr(6, 2) + bytes.substr(12),
                             seed.substr(0, 10));
                   changed += bytes != seed ? 1 : 0;
                 });
  EXPECT_GT(changed, Rounds / 2);
}

TEST(FieldMutator, WritesLimitsInEitherByteOrder)
{
  for (const ByteOrder order : {ByteOrder::Little, ByteOrder::Big})
  {
    int largest = 0;
    int one = 0;
    ForEachMutated(std::string(2, '\0'), FieldMutator({{0, 2}}, order),
                   [&](const std::string& bytes)
                   {
                     largest += bytes == "\xFF\xFF" ? 1 : 0;
                     one += bytes[order == ByteOrder::Little ? 0 : 1] == 1 &&
                                    bytes[order == ByteOrder::Little ? 1 : 0] == 0
                                ? 1
                                : 0;
                   });
    EXPECT_GT(largest, 0);
    EXPECT_GT(one, 0);
  }
}

TEST(TextMutator, KeepsBytesAfterHeader)
{
  const std::string bytes = "\n\n1 2 \1\2\3 a b";
  ForEachMutated("sizes: 1 2\ntype: short" + bytes, TextMutator({{}, {}, "\n\n"}),
                 [&](const std::string& text)
                 {
                   // The end mark belongs to the head.
                   const std::string rest = bytes.substr(2);
                   EXPECT_NE(text.find(rest), std::string::npos);
                 });
}

TEST(TextMutator, ReachesExtremeTexts)
{
  const std::string seed = "(key: 12)\n(other: 3)\n";
  int longer = 0;
  int repeated = 0;
  int deep = 0;
  int huge = 0;
  ForEachMutated(seed, TextMutator({{}, {{"(", ")"}}, ""}),
                 [&](const std::string& text)
                 {
                   const bool isLong = text.find(std::string(1000, 'k')) != std::string::npos;
                   longer += isLong ? 1 : 0;
                   repeated += text.find("(key: 12)\n(key: 12)\n") != std::string::npos ? 1 : 0;
                   deep += Deepest(text, '(', ')') >= 10000 ? 1 : 0;
                   huge += text.find("18446744073709551616") != std::string::npos ? 1 : 0;
                 });
  EXPECT_GT(longer, 0);
  EXPECT_GT(repeated, 0);
  EXPECT_GT(deep, 0);
  EXPECT_GT(huge, 0);
}

TEST(JsonMutator, MostlyKeepsJsonAndReachesExtremes)
{
  int valid = 0;
  int repeated = 0;
  int deep = 0;
  ForEachMutated(R"({"a": [1, 2.5, {"b": "text"}], "c": true})", JsonMutator({"a", "c"}),
                 [&](const std::string& text)
                 {
                   valid += nlohmann::json::accept(text) ? 1 : 0;
                   const std::size_t first = text.find("\"c\":");
                   repeated += first != std::string::npos &&
                                       text.find("\"c\":", first + 1) != std::string::npos
                                   ? 1
                                   : 0;
                   deep += Deepest(text, '[', ']') >= 10000 ? 1 : 0;
                 });
  EXPECT_GT(valid, Rounds / 2);
  EXPECT_GT(repeated, 0);
  EXPECT_GT(deep, 0);
}

TEST(GzipMutator, MostlyKeepsValidGzip)
{
  const std::string content(5000, 'a');
  int valid = 0;
  int larger = 0;
  Random random(11);
  const Mutator mutate = GzipMutator([](std::string& bytes, Random&) { bytes[0] = 'b'; });
  const std::string changed = Gzipped("b" + content.substr(1));
  for (int round = 0; round < 400; ++round)
  {
    std::string bytes = Gzipped(content);
    mutate(bytes, random);
    valid += bytes == changed ? 1 : 0;
    larger += bytes.size() > 1000 ? 1 : 0;
  }
  EXPECT_GT(valid, 200);
  EXPECT_GT(larger, 0);
}

TEST(OddDepth, ExceedsStack)
{
  Random random(11);
  std::size_t deepest = 0;
  for (int round = 0; round < 100; ++round)
  {
    deepest = std::max(deepest, OddDepth(random));
  }
  EXPECT_EQ(deepest, 100000U);
  EXPECT_EQ(Nested(2, "[", "1", "]"), "[[1]]");
}
} // namespace
} // namespace palpate::test::mutators_test
