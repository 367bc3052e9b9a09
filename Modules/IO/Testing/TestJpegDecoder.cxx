#include "CompressedDicom.h"
#include "JpegDecoder.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

using namespace palpate;
using namespace palpate::test;

namespace
{
constexpr int Columns = 40;
constexpr int Rows = 30;

int Value(int pixel)
{
  return pixel % Columns * (pixel / Columns) % 251;
}

// Eight bits in words of sixteen.
CompressedFrame Frame(Codec codec)
{
  const TemporaryFolder folder;
  DicomSliceSpec spec;
  spec.Columns = Columns;
  spec.Rows = Rows;
  spec.BitsAllocated = 8;
  spec.BitsStored = 8;
  spec.Pixels.reserve(Columns * Rows);
  for (int i = 0; i < Columns * Rows; ++i)
  {
    spec.Pixels.push_back(Value(i));
  }
  WriteDicomSlice(folder / "a.dcm", spec);
  Compress(folder / "a.dcm", codec);
  const std::string stream = Fragments(folder / "a.dcm").front();
  CompressedFrame frame;
  frame.Stream.assign(stream.begin(), stream.end());
  frame.Columns = Columns;
  frame.Rows = Rows;
  frame.BytesPerPixel = 2;
  frame.BitsStored = 16;
  frame.HighBit = 15;
  return frame;
}

bool Decode(const CompressedFrame& frame, std::vector<std::uint16_t>& pixels)
{
  pixels.assign(frame.PixelCount(), 0);
  return DecodeJpeg(frame, reinterpret_cast<std::uint8_t*>(pixels.data()));
}

bool IsDecoded(const CompressedFrame& frame)
{
  std::vector<std::uint16_t> pixels;
  return Decode(frame, pixels);
}
} // namespace

TEST(JpegDecoder, LosslessPixelsComeBackToTheBit)
{
  std::vector<std::uint16_t> pixels;
  ASSERT_TRUE(Decode(Frame(Codec::JpegLossless), pixels));
  for (int i = 0; i < Columns * Rows; ++i)
  {
    ASSERT_EQ(pixels[static_cast<std::size_t>(i)], Value(i)) << i;
  }
}

TEST(JpegDecoder, MissingDataBeforeTheEndMarkerIsNoSuccess)
{
  // The library fills what is missing, with a warning.
  for (const Codec codec : {Codec::JpegLossless, Codec::JpegBaseline})
  {
    CompressedFrame frame = Frame(codec);
    ASSERT_TRUE(IsDecoded(frame));
    frame.Stream.resize(frame.Stream.size() * 3 / 4);
    EXPECT_FALSE(IsDecoded(frame)) << CodecName(codec);
    frame.Stream.insert(frame.Stream.end(), {0x00, 0xFF, 0xD9});
    EXPECT_FALSE(IsDecoded(frame)) << CodecName(codec);
  }
}

TEST(JpegDecoder, AnotherSizeIsRefused)
{
  CompressedFrame frame = Frame(Codec::JpegLossless);
  frame.Columns = Rows;
  frame.Rows = Columns;
  EXPECT_FALSE(IsDecoded(frame));
}

TEST(JpegDecoder, ProgressiveStreamsAreRefused)
{
  CompressedFrame frame = Frame(Codec::JpegBaseline);
  for (std::size_t i = 0; i + 1 < frame.Stream.size(); ++i)
  {
    if (frame.Stream[i] == 0xFF && frame.Stream[i + 1] == 0xC0)
    {
      frame.Stream[i + 1] = 0xC2;
    }
  }
  EXPECT_FALSE(IsDecoded(frame));
}
