#include "RunLengthDecoder.h"

#include <gtest/gtest.h>

using namespace palpate;

namespace
{
// A frame of one row with its segments behind their header (PS3.5, G.5).
CompressedFrame Frame(int columns, const std::vector<std::vector<std::uint8_t>>& segments)
{
  CompressedFrame frame;
  frame.Columns = columns;
  frame.Rows = 1;
  frame.BytesPerPixel = static_cast<int>(segments.size());
  frame.Stream.resize(64, 0);
  frame.Stream[0] = static_cast<std::uint8_t>(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    frame.Stream[4 * (i + 1)] = static_cast<std::uint8_t>(frame.Stream.size());
    frame.Stream.insert(frame.Stream.end(), segments[i].begin(), segments[i].end());
  }
  return frame;
}

using Bytes = std::vector<std::uint8_t>;

bool Decode(const CompressedFrame& frame, Bytes& pixels)
{
  pixels.assign(frame.PixelCount() * static_cast<std::size_t>(frame.BytesPerPixel), 0);
  return DecodeRunLength(frame, pixels.data());
}
} // namespace

TEST(RunLengthDecoder, RunsAndLiteralsFollowEachOther)
{
  Bytes pixels;
  // Three literals, a code that means nothing, four times 9; then padding.
  ASSERT_TRUE(Decode(Frame(7, {{2, 1, 2, 3, 128, 253, 9, 0}}), pixels));
  EXPECT_EQ(pixels, (Bytes{1, 2, 3, 9, 9, 9, 9}));
}

TEST(RunLengthDecoder, FirstSegmentIsTheMostSignificantByte)
{
  Bytes pixels;
  ASSERT_TRUE(Decode(Frame(2, {{1, 0x12, 0x34}, {1, 0x56, 0x78}}), pixels));
  EXPECT_EQ(pixels, (Bytes{0x56, 0x12, 0x78, 0x34}));
}

TEST(RunLengthDecoder, MissingPixelsAreNoSuccess)
{
  Bytes pixels;
  EXPECT_FALSE(Decode(Frame(8, {{2, 1, 2, 3, 253, 9}}), pixels));
  EXPECT_FALSE(Decode(Frame(7, {{2, 1, 2, 3, 253}}), pixels));
  EXPECT_FALSE(Decode(Frame(7, {{7, 1, 2, 3}}), pixels));
  EXPECT_FALSE(Decode(Frame(7, {{}}), pixels));
}

TEST(RunLengthDecoder, RunsBeyondTheFrameAreNoSuccess)
{
  Bytes pixels;
  EXPECT_FALSE(Decode(Frame(6, {{2, 1, 2, 3, 253, 9}}), pixels));
}

TEST(RunLengthDecoder, HeaderMustFitTheFrame)
{
  Bytes pixels;
  CompressedFrame frame = Frame(4, {{253, 9}});
  frame.BytesPerPixel = 2;
  EXPECT_FALSE(Decode(frame, pixels));
  frame = Frame(4, {{253, 9}});
  frame.Stream[4] = 63; // inside the header
  EXPECT_FALSE(Decode(frame, pixels));
  frame.Stream[4] = 67; // beyond the end
  EXPECT_FALSE(Decode(frame, pixels));
  frame.Stream.resize(63);
  EXPECT_FALSE(Decode(frame, pixels));
}
