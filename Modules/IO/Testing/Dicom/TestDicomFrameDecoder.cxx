#include "CompressedDicom.h"
#include "DicomFrameDecoder.h"
#include "MessageOf.h"
#include "RandomShapes.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

namespace palpate::dicom_frame_decoder_test
{
namespace
{
using namespace palpate::test;

constexpr int Columns = 40;
constexpr int Rows = 30;

int Value(int pixel)
{
  return pixel % Columns * (pixel / Columns) % 251;
}

// Eight bits, in 16-bit words except for run-length coding.
CompressedFrame Frame(Codec codec)
{
  const TemporaryFolder folder;
  DicomSliceSpec spec;
  spec.Columns = Columns;
  spec.Rows = Rows;
  spec.BitsAllocated = 8;
  spec.BitsStored = 8;
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
  frame.BytesPerPixel = codec == Codec::RunLength ? 1 : 2;
  frame.BitsStored = 8 * frame.BytesPerPixel;
  frame.HighBit = frame.BitsStored - 1;
  return frame;
}

PixelCoding CodingOf(Codec codec)
{
  return codec == Codec::RunLength ? PixelCoding::RunLength
         : codec == Codec::JpegLs  ? PixelCoding::JpegLs
                                   : PixelCoding::Jpeg;
}

constexpr Codec Codecs[] = {Codec::RunLength, Codec::JpegLossless, Codec::JpegLs};

bool IsDecoded(DicomFrameDecoder& decoder, Codec codec, const CompressedFrame& frame)
{
  std::vector<std::uint8_t> pixels(2 * frame.PixelCount());
  return decoder.Decode("a.dcm", CodingOf(codec), frame, pixels.data());
}

TEST(DicomFrameDecoder, RestoresLosslessPixels)
{
  DicomFrameDecoder decoder;
  for (const Codec codec : Codecs)
  {
    const CompressedFrame frame = Frame(codec);
    const auto size = static_cast<std::size_t>(frame.BytesPerPixel);
    std::vector<std::uint8_t> pixels(size * frame.PixelCount(), 0xAA);
    ASSERT_TRUE(decoder.Decode("a.dcm", CodingOf(codec), frame, pixels.data()));
    for (int i = 0; i < Columns * Rows; ++i)
    {
      const std::uint8_t* pixel = pixels.data() + static_cast<std::size_t>(i) * size;
      ASSERT_EQ(pixel[0], Value(i)) << CodecName(codec) << i;
      ASSERT_EQ(pixel[size - 1], size == 1 ? Value(i) : 0) << CodecName(codec) << i;
    }
  }
}

TEST(DicomFrameDecoder, DetectsTruncation)
{
  DicomFrameDecoder decoder;
  for (const Codec codec :
       {Codec::RunLength, Codec::JpegLossless, Codec::JpegLs, Codec::JpegBaseline})
  {
    const CompressedFrame good = Frame(codec);
    ASSERT_TRUE(IsDecoded(decoder, codec, good));
    // The last bytes are padding and the end marker, whose absence loses no pixel.
    for (std::size_t size = 0; size + 8 < good.Stream.size(); size += 31)
    {
      CompressedFrame frame = good;
      frame.Stream.resize(size);
      EXPECT_FALSE(IsDecoded(decoder, codec, frame)) << CodecName(codec) << size;
    }
  }
}

TEST(DicomFrameDecoder, DetectsMissingDataBeforeEndMarker)
{
  // The codec fills missing data, with a warning.
  DicomFrameDecoder decoder;
  for (const Codec codec : {Codec::JpegLossless, Codec::JpegBaseline})
  {
    CompressedFrame frame = Frame(codec);
    frame.Stream.resize(frame.Stream.size() * 3 / 4);
    frame.Stream.insert(frame.Stream.end(), {0x00, 0xFF, 0xD9});
    EXPECT_FALSE(IsDecoded(decoder, codec, frame)) << CodecName(codec);
  }
}

TEST(DicomFrameDecoder, RejectsOtherSizeOrDepth)
{
  DicomFrameDecoder decoder;
  for (const Codec codec : {Codec::JpegLossless, Codec::JpegLs})
  {
    CompressedFrame frame = Frame(codec);
    frame.Columns = Rows;
    frame.Rows = Columns;
    EXPECT_FALSE(IsDecoded(decoder, codec, frame)) << CodecName(codec);
  }
  CompressedFrame words = Frame(Codec::RunLength);
  words.BytesPerPixel = 2;
  EXPECT_FALSE(IsDecoded(decoder, Codec::RunLength, words));
}

TEST(DicomFrameDecoder, RejectsProgressiveStreams)
{
  CompressedFrame frame = Frame(Codec::JpegBaseline);
  for (std::size_t i = 0; i + 1 < frame.Stream.size(); ++i)
  {
    if (frame.Stream[i] == 0xFF && frame.Stream[i + 1] == 0xC0)
    {
      frame.Stream[i + 1] = 0xC2;
    }
  }
  DicomFrameDecoder decoder;
  EXPECT_FALSE(IsDecoded(decoder, Codec::JpegBaseline, frame));
}

TEST(DicomFrameDecoder, RejectsJpegLsOfFewBits)
{
  // The precision follows the frame marker (0xFF 0xF7) and its length.
  CompressedFrame frame = Frame(Codec::JpegLs);
  for (std::size_t i = 0; i + 4 < frame.Stream.size(); ++i)
  {
    if (frame.Stream[i] == 0xFF && frame.Stream[i + 1] == 0xF7)
    {
      frame.Stream[i + 4] = 7;
      break;
    }
  }
  DicomFrameDecoder decoder;
  EXPECT_TRUE(Contains(MessageOf([&] { IsDecoded(decoder, Codec::JpegLs, frame); }),
                       "has JPEG-LS pixels of 7 bits, which are not supported"));
}

TEST(DicomFrameDecoder, DamagedFrameKeepsNextFramesReadable)
{
  Random random(23);
  DicomFrameDecoder decoder;
  int refused = 0;
  for (int round = 0; round < 100; ++round)
  {
    CompressedFrame frame = Frame(Codec::JpegLs);
    for (int change = 0; change < 4; ++change)
    {
      // After the markers.
      const std::size_t place = 30 + random() % (frame.Stream.size() - 30);
      frame.Stream[place] = static_cast<std::uint8_t>(random());
    }
    refused += IsDecoded(decoder, Codec::JpegLs, frame) ? 0 : 1;
  }
  EXPECT_GT(refused, 0);
  EXPECT_TRUE(IsDecoded(decoder, Codec::JpegLs, Frame(Codec::JpegLs)));
}
} // namespace
} // namespace palpate::dicom_frame_decoder_test
