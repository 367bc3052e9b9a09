#include "CompressedDicom.h"
#include "JpegLsDecoder.h"
#include "JpegLsParameters.h"
#include "RandomShapes.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <gtest/gtest.h>

using namespace palpate;
using namespace palpate::test;

namespace
{
using Bytes = std::vector<std::uint8_t>;

CompressedFrame Frame(const Bytes& stream, int columns, int rows, int bitsStored)
{
  CompressedFrame frame;
  frame.Stream = stream;
  frame.Columns = columns;
  frame.Rows = rows;
  frame.BytesPerPixel = 2;
  frame.BitsStored = bitsStored;
  frame.HighBit = bitsStored - 1;
  return frame;
}

std::vector<int> Decoded(const CompressedFrame& frame)
{
  std::vector<std::uint16_t> pixels(frame.PixelCount());
  if (!DecodeJpegLs(frame, reinterpret_cast<std::uint8_t*>(pixels.data())))
  {
    return {};
  }
  return {pixels.begin(), pixels.end()};
}

// Five bits, 10 x 8, coded by CharLS 2.4.1 (an encoder that owes nothing to DCMTK's CharLS 1).
const Bytes Lossless{0xFF, 0xD8, 0xFF, 0xF7, 0x00, 0x0B, 0x05, 0x00, 0x08, 0x00, 0x0A, 0x01,
                     0x01, 0x11, 0x00, 0xFF, 0xDA, 0x00, 0x08, 0x01, 0x01, 0x00, 0x00, 0x00,
                     0x00, 0x01, 0xDF, 0xF7, 0xFF, 0x0B, 0xCC, 0x01, 0x00, 0x04, 0x06, 0x00,
                     0x10, 0x14, 0x0E, 0x00, 0x02, 0x12, 0x10, 0x8E, 0x4F, 0x10, 0xA4, 0xD6,
                     0xB0, 0x00, 0x12, 0x27, 0x46, 0x87, 0xED, 0x5E, 0xFC, 0xFF, 0xD9};
const Bytes NearLossless{0xFF, 0xD8, 0xFF, 0xF7, 0x00, 0x0B, 0x05, 0x00, 0x08, 0x00,
                         0x0A, 0x01, 0x01, 0x11, 0x00, 0xFF, 0xDA, 0x00, 0x08, 0x01,
                         0x01, 0x00, 0x01, 0x00, 0x00, 0x3B, 0xFE, 0xFF, 0x71, 0xC8,
                         0xB1, 0x80, 0x40, 0x12, 0x83, 0x52, 0x5C, 0xBA, 0x54, 0xBA,
                         0x60, 0x8A, 0x94, 0xDA, 0xB9, 0x4B, 0xDE, 0x80, 0xFF, 0xD9};

// Three even rows, then curves.
std::vector<int> CodedImage()
{
  std::vector<int> values;
  for (int y = 0; y < 8; ++y)
  {
    for (int x = 0; x < 10; ++x)
    {
      values.push_back(y < 3 ? 7 : (x * x + 3 * y) % 32);
    }
  }
  return values;
}

// Even patches with a little noise, at least 400 pixels: DCMTK writes past its buffer where the
// stream is longer than the pixels.
DicomSliceSpec RandomImage(Random& random)
{
  DicomSliceSpec spec;
  spec.Columns = 20 + static_cast<int>(random() % 40);
  spec.Rows = 20 + static_cast<int>(random() % 40);
  spec.BitsStored = 8 + static_cast<int>(random() % 9);
  const auto range = std::uint64_t{1} << spec.BitsStored;
  const std::uint64_t noise = 1 + random() % (range / 8);
  std::uint64_t value = 0;
  for (int i = 0; i < spec.Columns * spec.Rows; ++i)
  {
    value = random() % 40 == 0 ? random() % (range - noise) : value;
    const bool isNoisy = (i / spec.Columns) % 8 < 4;
    spec.Pixels.push_back(static_cast<int>(value + (isNoisy ? random() % noise : 0)));
  }
  return spec;
}

Bytes Encoded(const DicomSliceSpec& spec, Codec codec)
{
  const TemporaryFolder folder;
  WriteDicomSlice(folder / "a.dcm", spec);
  Compress(folder / "a.dcm", codec);
  const std::string stream = Fragments(folder / "a.dcm").front();
  return {stream.begin(), stream.end()};
}
} // namespace

TEST(JpegLsDecoder, StreamOfAnotherEncoderIsDecoded)
{
  EXPECT_EQ(Decoded(Frame(Lossless, 10, 8, 5)), CodedImage());
}

TEST(JpegLsDecoder, NearLosslessIsOffByNoMoreThanStated)
{
  const std::vector<int> decoded = Decoded(Frame(NearLossless, 10, 8, 5));
  const std::vector<int> image = CodedImage();
  ASSERT_EQ(decoded.size(), image.size());
  for (std::size_t i = 0; i < image.size(); ++i)
  {
    EXPECT_LE(std::abs(decoded[i] - image[i]), 1) << i;
  }
}

TEST(JpegLsDecoder, RandomImagesComeBackToTheBit)
{
  Random random(21);
  for (int round = 0; round < 60; ++round)
  {
    const DicomSliceSpec spec = RandomImage(random);
    const Bytes stream = Encoded(spec, Codec::JpegLs);
    EXPECT_EQ(Decoded(Frame(stream, spec.Columns, spec.Rows, spec.BitsStored)), spec.Pixels)
        << "round " << round << ", " << spec.BitsStored << " bits";
  }
}

TEST(JpegLsDecoder, RandomImagesComeBackWithinTheirError)
{
  Random random(22);
  for (int round = 0; round < 30; ++round)
  {
    const DicomSliceSpec spec = RandomImage(random);
    const Bytes stream = Encoded(spec, Codec::JpegLsNearLossless);
    const std::vector<int> decoded =
        Decoded(Frame(stream, spec.Columns, spec.Rows, spec.BitsStored));
    ASSERT_EQ(decoded.size(), spec.Pixels.size());
    for (std::size_t i = 0; i < decoded.size(); ++i)
    {
      ASSERT_LE(std::abs(decoded[i] - spec.Pixels[i]), 2) << "round " << round;
    }
  }
}

TEST(JpegLsDecoder, EveryCutIsNoticed)
{
  for (std::size_t size = 0; size < Lossless.size(); ++size)
  {
    const Bytes cut(Lossless.begin(), Lossless.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_TRUE(Decoded(Frame(cut, 10, 8, 5)).empty()) << size;
  }
}

TEST(JpegLsDecoder, BitsThatAreLeftOverAreNoSuccess)
{
  Bytes longer = Lossless;
  longer.insert(longer.end() - 2, {0x12, 0x34});
  EXPECT_TRUE(Decoded(Frame(longer, 10, 8, 5)).empty());
}

TEST(JpegLsDecoder, ParametersOutOfTheirRangeAreRefused)
{
  // NEAR above half of the largest value; a point transform; a mapping table; six bits.
  const std::vector<std::pair<std::size_t, std::uint8_t>> changes{{22, 16}, {24, 1}, {21, 1},
                                                                  {6, 17},  {6, 1},  {11, 3}};
  for (const auto& [place, value] : changes)
  {
    Bytes stream = Lossless;
    stream[place] = value;
    EXPECT_FALSE(ReadJpegLsParameters(Frame(stream, 10, 8, 5))) << place;
  }
  EXPECT_FALSE(ReadJpegLsParameters(Frame(Lossless, 8, 10, 5)));
}

TEST(JpegLsDecoder, DefaultThresholdsAreTheStandards)
{
  // T.87, C.2.4.1.1: for 12 bits in its table C.3, for 7 and 8 from its formulas.
  const std::vector<std::array<int, 4>> expected{{7, 2, 3, 10}, {8, 3, 7, 21}, {12, 18, 67, 276}};
  for (const auto& [bits, first, second, third] : expected)
  {
    Bytes stream = Lossless;
    stream[6] = static_cast<std::uint8_t>(bits);
    const auto parameters = ReadJpegLsParameters(Frame(stream, 10, 8, bits));
    ASSERT_TRUE(parameters);
    EXPECT_EQ(parameters->Threshold1, first);
    EXPECT_EQ(parameters->Threshold2, second);
    EXPECT_EQ(parameters->Threshold3, third);
  }
}

TEST(JpegLsDecoder, StatedParametersAreTakenAndChecked)
{
  // Before the scan, whose marker is at place 15: MAXVAL, T1, T2, T3, RESET.
  Bytes stream = Lossless;
  const Bytes preset{0xFF, 0xF8, 0, 13, 1, 0, 20, 0, 3, 0, 5, 0, 9, 0, 40};
  stream.insert(stream.begin() + 15, preset.begin(), preset.end());
  const auto parameters = ReadJpegLsParameters(Frame(stream, 10, 8, 5));
  ASSERT_TRUE(parameters);
  EXPECT_EQ(parameters->MaximumValue, 20);
  EXPECT_EQ(parameters->Threshold1, 3);
  EXPECT_EQ(parameters->Threshold2, 5);
  EXPECT_EQ(parameters->Threshold3, 9);
  EXPECT_EQ(parameters->Reset, 40);
  EXPECT_EQ(parameters->Range, 21);
  EXPECT_EQ(parameters->RangeBits, 5);
  EXPECT_EQ(parameters->Limit, 26);
  stream[15 + 8] = 6; // T1 above T2
  EXPECT_FALSE(ReadJpegLsParameters(Frame(stream, 10, 8, 5)));
}
