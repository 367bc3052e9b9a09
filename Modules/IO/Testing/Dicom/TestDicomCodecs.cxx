#include "CompressedDicom.h"
#include "MessageOf.h"
#include "RandomShapes.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::dicom_codecs_test
{
namespace
{
using namespace palpate::test;

// 23 x 17 pixels: an odd number of bytes for 8-bit pixels. A slope and the extremes, with little
// enough noise to compress: DCMTK writes past its buffer if a JPEG-LS stream is longer than the
// pixels.
DicomSliceSpec NoisySlice(int bitsAllocated, int bitsStored, bool isSigned, unsigned int seed)
{
  DicomSliceSpec spec;
  spec.Columns = 23;
  spec.Rows = 17;
  spec.BitsAllocated = bitsAllocated;
  spec.BitsStored = bitsStored;
  spec.IsSigned = isSigned;
  Random random(seed);
  const int range = 1 << bitsStored;
  const int lowest = isSigned ? -range / 2 : 0;
  for (int i = 0; i < spec.Columns * spec.Rows; ++i)
  {
    const int noise = static_cast<int>(random() % static_cast<unsigned int>(range / 16));
    spec.Pixels.push_back(lowest + i * (range / 2) / 391 + noise);
  }
  spec.Pixels[0] = lowest;
  spec.Pixels[390] = lowest + range - 1;
  return spec;
}

// Both slices of a volume hold the pixels of `spec`, the second one compressed.
Volume ReadBack(DicomSliceSpec spec, Codec codec)
{
  const TemporaryFolder folder;
  WriteDicomSlice(folder / "1.dcm", spec);
  spec.PositionWorld = {0, 0, 3};
  WriteDicomSlice(folder / "2.dcm", spec);
  Compress(folder / "2.dcm", codec);
  return ReadVolume(folder.Path());
}

// The largest difference between the slices.
double LargestError(const Volume& volume)
{
  vtkDataArray* voxels = volume.Image->GetPointData()->GetScalars();
  const vtkIdType count = voxels->GetNumberOfTuples() / 2;
  double largest = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    largest = std::max(largest, std::abs(voxels->GetTuple1(count + i) - voxels->GetTuple1(i)));
  }
  return largest;
}

void ExpectSame(const DicomSliceSpec& spec)
{
  for (const Codec codec : LosslessCodecs)
  {
    const Volume volume = ReadBack(spec, codec);
    EXPECT_EQ(LargestError(volume), 0.0) << CodecName(codec);
    // The uncompressed slice equals the written pixels.
    EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(0, 0, 0, 0), spec.Pixels[0]);
    EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(22, 16, 1, 0), spec.Pixels[390]);
  }
}

TEST(DicomCodecs, RestoresUnsignedBytes)
{
  ExpectSame(NoisySlice(8, 8, false, 1));
}

TEST(DicomCodecs, RestoresSignedBytes)
{
  ExpectSame(NoisySlice(8, 8, true, 2));
}

TEST(DicomCodecs, RestoresUnsignedTwelveBits)
{
  ExpectSame(NoisySlice(16, 12, false, 3));
}

TEST(DicomCodecs, RestoresSignedTwelveBits)
{
  ExpectSame(NoisySlice(16, 12, true, 4));
}

TEST(DicomCodecs, RestoresUnsignedSixteenBits)
{
  ExpectSame(NoisySlice(16, 16, false, 5));
}

TEST(DicomCodecs, RestoresSignedSixteenBits)
{
  ExpectSame(NoisySlice(16, 16, true, 6));
}

TEST(DicomCodecs, RestoresFewStoredBits)
{
  // Streams of at most eight bits fill words of sixteen.
  ExpectSame(NoisySlice(16, 8, false, 7));
  ExpectSame(NoisySlice(16, 8, true, 8));
}

TEST(DicomCodecs, AppliesRescaleAfterDecoding)
{
  DicomSliceSpec spec = NoisySlice(16, 12, true, 9);
  spec.Slope = "2";
  spec.Intercept = "-10";
  for (const Codec codec : LosslessCodecs)
  {
    const Volume volume = ReadBack(spec, codec);
    EXPECT_EQ(volume.Image->GetScalarType(), VTK_INT);
    EXPECT_EQ(LargestError(volume), 0.0) << CodecName(codec);
    EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(22, 16, 1, 0), 2 * 2047 - 10);
  }
}

TEST(DicomCodecs, RestoresLossyCodingsApproximately)
{
  const DicomSliceSpec bytes = NoisySlice(8, 8, false, 10);
  // At quality 95 the largest quantisation step of the standard's tables is 12, and the errors of
  // 64 cosines rarely add up to more than two steps.
  EXPECT_LT(LargestError(ReadBack(bytes, Codec::JpegBaseline)), 24.0);
  EXPECT_GT(LargestError(ReadBack(bytes, Codec::JpegBaseline)), 0.0);
  // The error bound given to JPEG-LS.
  EXPECT_EQ(LargestError(ReadBack(bytes, Codec::JpegLsNearLossless)), 2.0);
  // Half of the bits keep the slope; only noise is lost, whose range is 16.
  EXPECT_LT(LargestError(ReadBack(bytes, Codec::Jpeg2000Lossy)), 16.0);
  EXPECT_GT(LargestError(ReadBack(bytes, Codec::Jpeg2000Lossy)), 0.0);
}

TEST(DicomCodecs, RestoresLossyTwelveBitsApproximately)
{
  const DicomSliceSpec spec = NoisySlice(16, 12, false, 11);
  const double error = LargestError(ReadBack(spec, Codec::JpegExtended));
  EXPECT_GT(error, 0.0);
  // As with bytes, whose steps are 16 times as large.
  EXPECT_LT(error, 24.0 * 16.0);
}

TEST(DicomCodecs, DoesNotPrintWarnings)
{
  DicomSliceSpec spec = NoisySlice(16, 12, false, 12);
  const TemporaryFolder folder;
  WriteDicomSlice(folder / "1.dcm", spec);
  spec.PositionWorld = {0, 0, 3};
  for (const Codec codec : {Codec::JpegLossless, Codec::JpegLs, Codec::Jpeg2000})
  {
    WriteDicomSlice(folder / "2.dcm", spec);
    Compress(folder / "2.dcm", codec);
    std::string stream = Fragments(folder / "2.dcm").front();
    stream.resize(stream.size() / 2);
    ReplaceFragments(folder / "2.dcm", {stream});
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const std::string message = MessageOf([&] { ReadVolume(folder.Path()); });
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_TRUE(Contains(message, "its pixels cannot be decoded as")) << CodecName(codec);
  }
}

TEST(DicomCodecs, ReadsLabelMapsInEveryLosslessCoding)
{
  for (const Codec codec : LosslessCodecs)
  {
    for (const int bits : {8, 16})
    {
      DicomSegmentationSpec spec;
      spec.Kind = "LABELMAP";
      spec.BitsAllocated = bits;
      spec.Columns = 20;
      spec.Rows = 15;
      for (int frame = 0; frame < 2; ++frame)
      {
        spec.Frames.push_back({0, 3.0 * frame, {}});
        for (int i = 0; i < 300; ++i)
        {
          spec.Frames.back().Pixels.push_back(i / 7 % (2 + frame));
        }
      }
      const TemporaryFolder folder;
      WriteDicomSegmentation(folder / "a.dcm", spec);
      Compress(folder / "a.dcm", codec);
      const Segmentation segmentation = ReadSegmentation(folder / "a.dcm");
      vtkDataArray* labels = segmentation.Layers[0]->GetPointData()->GetScalars();
      for (int i = 0; i < 600; ++i)
      {
        EXPECT_EQ(labels->GetTuple1(i), i % 300 / 7 % (2 + i / 300))
            << CodecName(codec) << ", " << bits << " bits, pixel " << i;
      }
    }
  }
}
} // namespace
} // namespace palpate::dicom_codecs_test
