#include "CompressedDicom.h"
#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::encapsulated_frames_test
{
namespace
{
using namespace palpate::test;

// Splits a stream into pieces of even length, the last of which may be shorter.
std::vector<std::string> Split(const std::string& stream, std::size_t length)
{
  std::vector<std::string> pieces;
  for (std::size_t place = 0; place < stream.size(); place += length)
  {
    pieces.push_back(stream.substr(place, length));
  }
  return pieces;
}

// A label map of three frames of 16 x 12 pixels, each labelled in a different third of its rows.
void WriteThreeFrames(const std::filesystem::path& file, Codec codec)
{
  DicomSegmentationSpec spec;
  spec.Kind = "LABELMAP";
  spec.BitsAllocated = 8;
  spec.Columns = 16;
  spec.Rows = 12;
  for (int frame = 0; frame < 3; ++frame)
  {
    std::vector<int> pixels(192, 0);
    std::fill_n(pixels.begin() + 64 * frame, 64, frame + 1);
    spec.Frames.push_back({0, 3.0 * frame, pixels});
  }
  WriteDicomSegmentation(file, spec);
  Compress(file, codec);
}

void ExpectThreeFrames(const std::filesystem::path& file)
{
  const Segmentation segmentation = ReadSegmentation(file);
  for (int frame = 0; frame < 3; ++frame)
  {
    for (int row = 0; row < 12; ++row)
    {
      EXPECT_EQ(segmentation.Layers[0]->GetScalarComponentAsDouble(1, row, frame, 0),
                row / 4 == frame ? frame + 1 : 0);
    }
  }
}

constexpr Codec StreamCodecs[] = {Codec::JpegLossless, Codec::JpegLs, Codec::Jpeg2000};

TEST(EncapsulatedFrames, FrameMaySpanFragments)
{
  for (const Codec codec : LosslessCodecs)
  {
    const TemporaryFolder folder;
    DicomSliceSpec spec;
    spec.Columns = 40;
    spec.Rows = 30;
    for (int i = 0; i < 1200; ++i)
    {
      spec.Pixels.push_back(i * i % 4093);
    }
    WriteDicomSlice(folder / "1.dcm", spec);
    spec.PositionWorld = {0, 0, 3};
    WriteDicomSlice(folder / "2.dcm", spec);
    Compress(folder / "2.dcm", codec);
    ReplaceFragments(folder / "2.dcm", Split(Fragments(folder / "2.dcm").front(), 100));
    const Volume volume = ReadVolume(folder.Path());
    for (vtkIdType i = 0; i < 1200; ++i)
    {
      ASSERT_EQ(volume.Image->GetPointData()->GetScalars()->GetTuple1(1200 + i),
                spec.Pixels[static_cast<std::size_t>(i)])
          << CodecName(codec);
    }
  }
}

TEST(EncapsulatedFrames, OffsetTableLocatesFrames)
{
  for (const Codec codec : LosslessCodecs)
  {
    const TemporaryFolder folder;
    const auto file = folder / "a.dcm";
    WriteThreeFrames(file, codec);
    std::vector<std::string> pieces;
    std::vector<std::uint32_t> offsets;
    std::uint32_t place = 0;
    for (const std::string& stream : Fragments(file))
    {
      offsets.push_back(place);
      for (const std::string& piece : Split(stream, 26))
      {
        place += 8 + static_cast<std::uint32_t>(piece.size() + piece.size() % 2);
        pieces.push_back(piece);
      }
    }
    ReplaceFragments(file, pieces, offsets);
    ExpectThreeFrames(file);
  }
}

TEST(EncapsulatedFrames, FindsFramesByMarkersWithoutOffsets)
{
  for (const Codec codec : StreamCodecs)
  {
    const TemporaryFolder folder;
    const auto file = folder / "a.dcm";
    WriteThreeFrames(file, codec);
    std::vector<std::string> pieces;
    for (const std::string& stream : Fragments(file))
    {
      const std::vector<std::string> split = Split(stream, 26);
      pieces.insert(pieces.end(), split.begin(), split.end());
    }
    ReplaceFragments(file, pieces);
    ExpectThreeFrames(file);
    // A wrong table is ignored.
    ReplaceFragments(file, pieces, {0, 5, 10});
    ExpectThreeFrames(file);
  }
}

TEST(EncapsulatedFrames, OneFragmentPerFrameNeedsNoOffsets)
{
  for (const Codec codec : LosslessCodecs)
  {
    const TemporaryFolder folder;
    const auto file = folder / "a.dcm";
    WriteThreeFrames(file, codec);
    ExpectThreeFrames(file);
    ReplaceFragments(file, Fragments(file), {77, 3, 5});
    ExpectThreeFrames(file);
  }
}

TEST(EncapsulatedFrames, SkipsPaddingAfterFrame)
{
  for (const Codec codec : LosslessCodecs)
  {
    const TemporaryFolder folder;
    const auto file = folder / "a.dcm";
    WriteThreeFrames(file, codec);
    std::vector<std::string> padded = Fragments(file);
    for (std::string& stream : padded)
    {
      stream += std::string(6, '\0');
    }
    ReplaceFragments(file, padded);
    ExpectThreeFrames(file);
  }
}

TEST(EncapsulatedFrames, RejectsFewerFragmentsThanFrames)
{
  const TemporaryFolder folder;
  const auto file = folder / "a.dcm";
  WriteThreeFrames(file, Codec::RunLength);
  std::vector<std::string> streams = Fragments(file);
  streams.pop_back();
  ReplaceFragments(file, streams);
  EXPECT_TRUE(Contains(MessageOf([&] { ReadSegmentation(file); }),
                       "its pixel data do not match its header"));
}

TEST(EncapsulatedFrames, RejectsFragmentBeyondEndOfFile)
{
  const TemporaryFolder folder;
  const auto file = folder / "a.dcm";
  WriteThreeFrames(file, Codec::RunLength);
  std::string bytes = ReadAll(file);
  // The last fragment is preceded by its length; the sequence's delimiter is the last eight bytes.
  const std::size_t length = bytes.size() - 8 - Fragments(file).back().size() - 4;
  bytes[length + 3] = 0x7F;
  WriteAll(file, bytes);
  EXPECT_TRUE(Contains(MessageOf([&] { ReadSegmentation(file); }), "is truncated or damaged"));
}

TEST(EncapsulatedFrames, RejectsFragmentsWithoutFrame)
{
  const TemporaryFolder folder;
  const auto file = folder / "a.dcm";
  WriteThreeFrames(file, Codec::RunLength);
  std::vector<std::string> streams = Fragments(file);
  streams.push_back(streams.back());
  ReplaceFragments(file, streams, {0, 4, 8});
  EXPECT_TRUE(Contains(MessageOf([&] { ReadSegmentation(file); }),
                       "its pixel data do not match its header"));
}
} // namespace
} // namespace palpate::encapsulated_frames_test
