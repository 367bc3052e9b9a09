#include "CompressedDicom.h"
#include "DicomTransferSyntax.h"
#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include <gtest/gtest.h>

namespace palpate::dicom_transfer_syntax_test
{
namespace
{
using namespace palpate::test;

// A series whose second slice states a wrong transfer syntax.
std::string SeriesRefusal(const std::string& syntax)
{
  const TemporaryFolder folder;
  DicomSliceSpec spec;
  WriteDicomSlice(folder / "1.dcm", spec);
  spec.PositionWorld = {0, 0, 3};
  WriteDicomSlice(folder / "2.dcm", spec);
  Compress(folder / "2.dcm", Codec::Jpeg2000);
  StateTransferSyntax(folder / "2.dcm", syntax);
  return MessageOf([&] { ReadVolume(folder.Path()); });
}

TEST(DicomTransferSyntax, UncompressedSyntaxesAreNative)
{
  for (const char* uid : {"1.2.840.10008.1.2", "1.2.840.10008.1.2.1", "1.2.840.10008.1.2.2",
                          "1.2.840.10008.1.2.1.99"})
  {
    EXPECT_EQ(PixelCodingOf(uid), PixelCoding::Native) << uid;
  }
}

TEST(DicomTransferSyntax, CompressedSyntaxesHaveDecoders)
{
  EXPECT_EQ(PixelCodingOf("1.2.840.10008.1.2.5"), PixelCoding::RunLength);
  for (const char* uid : {"1.2.840.10008.1.2.4.50", "1.2.840.10008.1.2.4.51",
                          "1.2.840.10008.1.2.4.57", "1.2.840.10008.1.2.4.70"})
  {
    EXPECT_EQ(PixelCodingOf(uid), PixelCoding::Jpeg) << uid;
  }
  EXPECT_EQ(PixelCodingOf("1.2.840.10008.1.2.4.80"), PixelCoding::JpegLs);
  EXPECT_EQ(PixelCodingOf("1.2.840.10008.1.2.4.81"), PixelCoding::JpegLs);
  EXPECT_EQ(PixelCodingOf("1.2.840.10008.1.2.4.90"), PixelCoding::Jpeg2000);
  EXPECT_EQ(PixelCodingOf("1.2.840.10008.1.2.4.91"), PixelCoding::Jpeg2000);
}

TEST(DicomTransferSyntax, OthersAreUnsupported)
{
  // Progressive JPEG, JPEG 2000 of several components, JPIP, MPEG, HEVC, HTJ2K, a private one.
  for (const char* uid :
       {"1.2.840.10008.1.2.4.55", "1.2.840.10008.1.2.4.92", "1.2.840.10008.1.2.4.94",
        "1.2.840.10008.1.2.4.100", "1.2.840.10008.1.2.4.107", "1.2.840.10008.1.2.4.201", "1.2.3.4"})
  {
    EXPECT_EQ(PixelCodingOf(uid), PixelCoding::Unread) << uid;
  }
}

TEST(DicomTransferSyntax, RefusalNamesTransferSyntax)
{
  EXPECT_TRUE(Contains(
      SeriesRefusal("1.2.840.10008.1.2.4.92"),
      "2.dcm stores its pixels in the transfer syntax JPEG 2000 Part 2 Multicomponent Image "
      "Compression (Lossless only) (1.2.840.10008.1.2.4.92), which is not supported; export it "
      "again "
      "uncompressed or as RLE, JPEG, JPEG-LS or JPEG 2000."));
  EXPECT_TRUE(Contains(SeriesRefusal("1.2.840.10008.1.2.4.100"),
                       "in the transfer syntax MPEG2 Main Profile @ Main Level "
                       "(1.2.840.10008.1.2.4.100), which is not supported"));
}

TEST(DicomTransferSyntax, NamesSyntaxesUnknownToDcmtk)
{
  EXPECT_TRUE(Contains(SeriesRefusal("1.2.840.10008.1.2.4.201"),
                       "in the transfer syntax High-Throughput JPEG 2000 "
                       "(1.2.840.10008.1.2.4.201), which is not supported"));
  EXPECT_TRUE(
      Contains(SeriesRefusal("1.2.3.4"), "in the transfer syntax 1.2.3.4, which is not supported"));
}

TEST(DicomTransferSyntax, SegmentationRefusalNamesTransferSyntax)
{
  const TemporaryFolder folder;
  DicomSegmentationSpec spec;
  spec.Kind = "LABELMAP";
  spec.BitsAllocated = 8;
  spec.Frames = {{0, 0.0, std::vector<int>(12, 1)}, {0, 3.0, std::vector<int>(12, 1)}};
  for (const char* syntax : {"1.2.840.10008.1.2.4.92", "1.2.840.10008.1.2.4.201"})
  {
    WriteDicomSegmentation(folder / "a.dcm", spec);
    Compress(folder / "a.dcm", Codec::Jpeg2000);
    StateTransferSyntax(folder / "a.dcm", syntax);
    EXPECT_TRUE(Contains(MessageOf([&] { ReadSegmentation(folder / "a.dcm"); }),
                         std::string("(") + syntax + "), which is not supported"));
  }
}

TEST(DicomTransferSyntax, RejectsCompressedBits)
{
  const TemporaryFolder folder;
  DicomSegmentationSpec spec;
  spec.BitsAllocated = 8;
  spec.Frames = {{1, 0.0, std::vector<int>(12, 1)}, {1, 3.0, std::vector<int>(12, 1)}};
  WriteDicomSegmentation(folder / "a.dcm", spec);
  Compress(folder / "a.dcm", Codec::Jpeg2000);
  std::string bytes = ReadAll(folder / "a.dcm");
  const std::string bitsAllocated("\x28\0\0\1US\2\0", 8);
  bytes[bytes.find(bitsAllocated) + 8] = 1;
  WriteAll(folder / "a.dcm", bytes);
  EXPECT_TRUE(Contains(MessageOf([&] { ReadSegmentation(folder / "a.dcm"); }),
                       "has compressed pixels of one bit, which are not supported; export the "
                       "segmentation again uncompressed or with eight bits a pixel."));
}
} // namespace
} // namespace palpate::dicom_transfer_syntax_test
