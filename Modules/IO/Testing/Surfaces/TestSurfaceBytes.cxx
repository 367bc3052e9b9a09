#include "SurfaceBytes.h"

#include "MessageOf.h"

#include <gtest/gtest.h>

namespace palpate::surface_bytes_test
{
namespace
{
using namespace palpate::test;
using namespace std::string_view_literals;

const std::string Name = "a.x";

TEST(SurfaceBytes, DecodesNumbersOfEveryTypeAndOrder)
{
  const std::string_view bytes = "\xfe\xff\x01\x80\0\0\xf0\x3f"sv;
  const auto little = [&](std::size_t start, const NumberType& type)
  { return NumberOf(bytes.substr(start, type.Bytes), type, NumberCoding::LittleEndian); };
  EXPECT_EQ(little(0, {1, false, false}), 254.0);
  EXPECT_EQ(little(0, {1, true, false}), -2.0);
  EXPECT_EQ(little(0, {2, true, false}), -2.0);
  EXPECT_EQ(little(0, {4, true, false}), -2147352578.0);
  EXPECT_EQ(little(0, {4, false, false}), 2147614718.0);
  EXPECT_EQ(little(4, {4, true, true}), 1.875);
  const auto big = [](std::string_view eight, const NumberType& type)
  { return NumberOf(eight, type, NumberCoding::BigEndian); };
  EXPECT_EQ(big("\x3f\xf0\0\0\0\0\0\0"sv, {8, true, true}), 1.0);
  EXPECT_EQ(big("\xff\xff\xff\xff\xff\xff\xff\xfd"sv, {8, true, false}), -3.0);
  EXPECT_EQ(big("\x80\0\0\0\0\0\0\0"sv, {8, false, false}), 9223372036854775808.0);
}

TEST(SurfaceBytes, TakesLinesAndWords)
{
  SurfaceBytes file("ply\r\n\n \ta 1.5\v2", Name, "X");
  EXPECT_EQ(file.Line(), "ply");
  EXPECT_EQ(file.Line(), "");
  EXPECT_EQ(file.Word(), "a");
  EXPECT_EQ(file.Number({4, true, true}), 1.5);
  EXPECT_EQ(file.Word(), "2");
  EXPECT_EQ(file.Word(), "");
  EXPECT_TRUE(file.IsEmpty());
}

// Before memory is reserved for them.
TEST(SurfaceBytes, CountsAreBoundedByFile)
{
  for (const NumberCoding coding : {NumberCoding::Text, NumberCoding::BigEndian})
  {
    SurfaceBytes file("1 2 3 4", Name, "X");
    file.Coding = coding;
    const bool isText = file.IsText();
    const auto refusal = [&](std::size_t count) {
      return MessageOf([&] { file.RequireRoom(count, file.LeastBytes({1, true, false})); });
    };
    EXPECT_EQ(refusal(isText ? 4 : 7), "no error");
    EXPECT_EQ(refusal(isText ? 5 : 8),
              "a.x is not a readable X surface: it ends too early; write the file again.");
    EXPECT_EQ(MessageOf([&] { file.RequireRoom(1, 0); }), refusal(8));
    EXPECT_EQ(file.CountOf("56"), 56U);
    for (const char* count : {"57", "-1", "0.5", "1x", "1e999", ""})
    {
      EXPECT_TRUE(Contains(MessageOf([&] { file.CountOf(count); }), "counts is invalid")) << count;
    }
  }
}
} // namespace
} // namespace palpate::surface_bytes_test
