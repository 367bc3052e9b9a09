#include "CompressedDicom.h"
#include "Jpeg2000Decoder.h"

#include <gtest/gtest.h>

namespace palpate::jpeg2000_decoder_test
{
namespace
{
using namespace palpate::test;

constexpr int Columns = 40;
constexpr int Rows = 30;

std::vector<int> Slope()
{
  std::vector<int> values;
  values.reserve(Columns * Rows);
  for (int i = 0; i < Columns * Rows; ++i)
  {
    values.push_back(i % Columns - i / Columns);
  }
  return values;
}

CompressedFrame Frame(int precision, bool isSigned)
{
  std::vector<int> values = Slope();
  for (int& value : values)
  {
    value = isSigned ? value : value & ((1 << precision) - 1);
  }
  const std::string stream = Jpeg2000Stream(values, Columns, Rows, precision, isSigned);
  CompressedFrame frame;
  frame.Stream.assign(stream.begin(), stream.end());
  frame.Columns = Columns;
  frame.Rows = Rows;
  frame.BytesPerPixel = 2;
  frame.BitsStored = 16;
  frame.HighBit = 15;
  frame.IsSigned = true;
  return frame;
}

bool Decode(const CompressedFrame& frame, std::vector<std::int16_t>& pixels)
{
  pixels.assign(frame.PixelCount(), 0);
  return DecodeJpeg2000(frame, reinterpret_cast<std::uint8_t*>(pixels.data()));
}

void ExpectSlope(const CompressedFrame& frame)
{
  std::vector<std::int16_t> pixels;
  ASSERT_TRUE(Decode(frame, pixels));
  EXPECT_EQ(std::vector<int>(pixels.begin(), pixels.end()), Slope());
}

TEST(Jpeg2000Decoder, TakesSignFromHeader)
{
  ExpectSlope(Frame(12, true));
  ExpectSlope(Frame(12, false));
  ExpectSlope(Frame(16, true));
  ExpectSlope(Frame(16, false));
}

TEST(Jpeg2000Decoder, SkipsBoxesAroundCodestream)
{
  CompressedFrame frame = Frame(12, true);
  const std::vector<std::uint8_t> boxes{0, 0, 0, 12, 'j', 'P', ' ', ' ', 0x0D, 0x0A, 0x87, 0x0A};
  frame.Stream.insert(frame.Stream.begin(), boxes.begin(), boxes.end());
  ExpectSlope(frame);
}

TEST(Jpeg2000Decoder, RejectsOtherSizeOrDepth)
{
  std::vector<std::int16_t> pixels;
  CompressedFrame frame = Frame(12, true);
  frame.Columns = Columns + 1;
  EXPECT_FALSE(Decode(frame, pixels));
  frame.Columns = Rows;
  frame.Rows = Columns;
  EXPECT_FALSE(Decode(frame, pixels));
  frame = Frame(12, true);
  frame.BytesPerPixel = 1;
  EXPECT_FALSE(Decode(frame, pixels));
}

TEST(Jpeg2000Decoder, RejectsTinyTilesBeforeAllocation)
{
  std::vector<std::int16_t> pixels;
  CompressedFrame frame = Frame(12, true);
  // XTsiz and YTsiz of the SIZ marker, four bytes each.
  frame.Stream[4 + 20 + 3] = 5;
  frame.Stream[4 + 24 + 3] = 5;
  EXPECT_FALSE(Decode(frame, pixels));
  frame.Stream[4 + 20 + 3] = 0;
  EXPECT_FALSE(Decode(frame, pixels));
}

TEST(Jpeg2000Decoder, DetectsEveryTruncation)
{
  std::vector<std::int16_t> pixels;
  const CompressedFrame good = Frame(12, true);
  // The last two bytes are the end marker, whose absence loses no pixel.
  for (std::size_t size = 0; size + 2 < good.Stream.size(); size += 7)
  {
    CompressedFrame frame = good;
    frame.Stream.resize(size);
    EXPECT_FALSE(Decode(frame, pixels)) << size;
  }
}
} // namespace
} // namespace palpate::jpeg2000_decoder_test
