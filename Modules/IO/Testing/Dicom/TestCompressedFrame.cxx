#include "CompressedFrame.h"

#include <array>
#include <gtest/gtest.h>

namespace palpate::compressed_frame_test
{
namespace
{
// The 16-bit word made from a sample.
int Stored(std::uint32_t sample, int precision, int bitsStored, int highBit, bool isSigned)
{
  CompressedFrame frame;
  frame.BytesPerPixel = 2;
  frame.BitsStored = bitsStored;
  frame.HighBit = highBit;
  frame.IsSigned = isSigned;
  std::array<std::uint8_t, 4> pixels{};
  frame.Store(sample, precision, 1, pixels.data());
  return pixels[2] | pixels[3] << 8;
}

TEST(CompressedFrame, KeepsFullSamples)
{
  EXPECT_EQ(Stored(0x8765, 16, 16, 15, true), 0x8765);
  EXPECT_EQ(Stored(0xF765, 16, 12, 11, true), 0xF765);
}

TEST(CompressedFrame, SignExtendsNarrowSamples)
{
  EXPECT_EQ(Stored(0x80, 8, 16, 15, true), 0xFF80);
  EXPECT_EQ(Stored(0x80, 8, 16, 15, false), 0x0080);
  EXPECT_EQ(Stored(0x7F, 8, 16, 15, true), 0x007F);
}

TEST(CompressedFrame, ShiftsNarrowSamplesToHighBit)
{
  EXPECT_EQ(Stored(0x123, 12, 12, 15, false), 0x1230);
  EXPECT_EQ(Stored(0x1230, 16, 12, 15, false), 0x1230);
}
} // namespace
} // namespace palpate::compressed_frame_test
