#include "CompressedDicom.h"
#include "InputError.h"
#include "RandomShapes.h"
#include "Segmentation.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "Volume.h"

#include <gtest/gtest.h>

using namespace palpate;
using namespace palpate::test;

// Damaged files must be read or refused; whatever else happens (a crash, another exception, an
// endless loop) fails the test program.
namespace
{
template <typename Read>
void ReadOrRefuse(const Read& read)
{
  try
  {
    read();
  }
  catch (const InputError&)
  {
  }
}

// A new file each time: rewriting one makes some file systems wait for the disk.
void Replace(const std::filesystem::path& file, const std::string& bytes)
{
  std::filesystem::remove(file);
  WriteAll(file, bytes);
}

std::string Damaged(const std::string& good, std::size_t pixelBytes, Random& random)
{
  std::string bytes = good;
  const auto kind = random() % 4;
  if (kind == 0)
  {
    return bytes.substr(0, random() % bytes.size());
  }
  // The whole file, the compressed pixels, or their first hundred bytes, which hold their headers.
  const std::size_t first = kind == 1 ? 0 : bytes.size() - pixelBytes;
  const std::size_t count =
      kind == 3 ? std::min<std::size_t>(100, pixelBytes) : bytes.size() - first;
  const auto flips = 1 + random() % 4;
  for (std::size_t flip = 0; flip < flips; ++flip)
  {
    bytes[first + random() % count] = static_cast<char>(random() % 256);
  }
  return bytes;
}

// The second of two slices is damaged.
void FuzzSlice(Codec codec, DicomSliceSpec spec, unsigned int seed)
{
  const TemporaryFolder folder;
  spec.Columns = 24;
  spec.Rows = 20;
  for (int i = 0; i < 480; ++i)
  {
    spec.Pixels.push_back((i * i / 50 + i % 24) % 200);
  }
  WriteDicomSlice(folder / "1.dcm", spec);
  spec.PositionWorld = {0, 0, 3};
  WriteDicomSlice(folder / "2.dcm", spec);
  Compress(folder / "2.dcm", codec);
  const std::string good = ReadAll(folder / "2.dcm");
  const std::size_t pixelBytes = Fragments(folder / "2.dcm").front().size();
  Random random(seed);
  for (int round = 0; round < 300; ++round)
  {
    Replace(folder / "2.dcm", Damaged(good, pixelBytes, random));
    ReadOrRefuse([&] { ReadVolume(folder.Path()); });
  }
}

DicomSliceSpec Bits(int allocated, int stored, bool isSigned)
{
  DicomSliceSpec spec;
  spec.BitsAllocated = allocated;
  spec.BitsStored = stored;
  spec.IsSigned = isSigned;
  return spec;
}
} // namespace

TEST(CompressedDicomFuzz, RunLength)
{
  FuzzSlice(Codec::RunLength, Bits(16, 12, true), 1);
  FuzzSlice(Codec::RunLength, Bits(8, 8, false), 2);
}

TEST(CompressedDicomFuzz, JpegBaseline)
{
  FuzzSlice(Codec::JpegBaseline, Bits(8, 8, false), 3);
}

TEST(CompressedDicomFuzz, JpegExtended)
{
  FuzzSlice(Codec::JpegExtended, Bits(16, 12, false), 4);
}

TEST(CompressedDicomFuzz, JpegLossless)
{
  FuzzSlice(Codec::JpegLossless, Bits(8, 8, false), 5);
  FuzzSlice(Codec::JpegLossless, Bits(16, 12, false), 6);
  FuzzSlice(Codec::JpegLossless, Bits(16, 16, true), 7);
}

TEST(CompressedDicomFuzz, JpegLs)
{
  FuzzSlice(Codec::JpegLs, Bits(8, 8, false), 8);
  FuzzSlice(Codec::JpegLs, Bits(16, 16, true), 9);
  FuzzSlice(Codec::JpegLsNearLossless, Bits(16, 12, false), 10);
}

TEST(CompressedDicomFuzz, Jpeg2000)
{
  FuzzSlice(Codec::Jpeg2000, Bits(8, 8, false), 11);
  FuzzSlice(Codec::Jpeg2000, Bits(16, 16, true), 12);
  FuzzSlice(Codec::Jpeg2000Lossy, Bits(16, 12, false), 13);
}

TEST(CompressedDicomFuzz, SegmentationsOfSeveralFrames)
{
  const TemporaryFolder folder;
  const auto file = folder / "a.dcm";
  DicomSegmentationSpec spec;
  spec.Kind = "LABELMAP";
  spec.BitsAllocated = 8;
  spec.Columns = 16;
  spec.Rows = 12;
  spec.Frames = {{0, 0.0, std::vector<int>(192, 1)}, {0, 3.0, std::vector<int>(192, 2)}};
  for (const Codec codec : LosslessCodecs)
  {
    WriteDicomSegmentation(file, spec);
    Compress(file, codec);
    const std::string good = ReadAll(file);
    Random random(14);
    for (int round = 0; round < 150; ++round)
    {
      Replace(file, Damaged(good, 200, random));
      ReadOrRefuse([&] { ReadSegmentation(file); });
    }
    std::filesystem::remove(file);
  }
}
