#include "AddressSpaceLimit.h"
#include "HostileDicom.h"
#include "MessageOf.h"
#include "SegmentationFile.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include <ctime>
#include <gtest/gtest.h>

namespace palpate::hostile_dicom_test
{
namespace
{
using namespace palpate::test;

// Memory and time are bounded by the actual content of a DICOM file, not by its header.
constexpr rlim_t SomeMemory = rlim_t{1} << 30; // limit for reading a file of some bytes

std::string Refusal(const std::string& bytes)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.dcm", bytes);
  const AddressSpaceLimit limit(SomeMemory);
  return MessageOf([&] { ReadSegmentation(folder / "a.dcm"); });
}

double CpuSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

TEST(HostileDicom, ReadsSegmentationWithoutFalseClaims)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.dcm", ClaimedSegmentationBytes({}));
  const Segmentation segmentation = ReadSegmentation(folder / "a.dcm");
  EXPECT_EQ(segmentation.Segments.size(), 1U);
}

TEST(HostileDicom, RejectsSliceNumbersBeyondInt)
{
  ClaimedSegmentation claim;
  claim.Frames = "2";
  for (const char* height : {"3e9", "1e12", "1e300", "-1e12"})
  {
    claim.Heights = {"0", height};
    EXPECT_TRUE(Contains(Refusal(ClaimedSegmentationBytes(claim)), "slice spacings apart"))
        << height;
  }
  claim.Heights = {"-1e308", "1.7e308"};
  EXPECT_TRUE(Contains(Refusal(ClaimedSegmentationBytes(claim)), "at an infinite distance"));
}

TEST(HostileDicom, RejectsFramesWithoutPixels)
{
  ClaimedSegmentation claim;
  claim.Columns = 65535;
  claim.Rows = 65535; // the product exceeds int
  EXPECT_TRUE(Contains(Refusal(ClaimedSegmentationBytes(claim)),
                       "has fewer pixels than its header declares"));
  claim.Frames = "2147483647";
  EXPECT_TRUE(Contains(Refusal(ClaimedSegmentationBytes(claim)),
                       "has fewer pixels than its header declares"));
  claim.Frames = "1e18"; // not a whole number of the type
  EXPECT_TRUE(Contains(Refusal(ClaimedSegmentationBytes(claim)), "has no frames"));
}

TEST(HostileDicom, RejectsFramesWithoutItem)
{
  ClaimedSegmentation claim;
  claim.Frames = "1000000";
  claim.Pixels = std::string(500000, '\xFF');
  EXPECT_TRUE(
      Contains(Refusal(ClaimedSegmentationBytes(claim)), "describes 1 of its 1000000 frames"));
}

TEST(HostileDicom, RejectsGigabytesOfEmptySlices)
{
  ClaimedSegmentation claim;
  claim.Columns = 1024;
  claim.Rows = 1024;
  claim.Frames = "2";
  claim.Heights = {"0", "60000"};
  claim.Pixels = std::string(2 * 1024 * 1024 / 8, '\xFF');
  EXPECT_TRUE(Contains(Refusal(ClaimedSegmentationBytes(claim)), "most of them without data"));
}

TEST(HostileDicom, EmptyFramesTakeLinearTime)
{
  // Twelve bytes per frame. Searching from the first one for each would take minutes.
  constexpr int Frames = 300000;
  ClaimedSegmentation claim;
  claim.Frames = std::to_string(Frames);
  claim.Heights = {};
  claim.EmptyItems = Frames;
  claim.Pixels = std::string(Frames / 2, '\xFF');
  const std::string bytes = ClaimedSegmentationBytes(claim);
  const double start = CpuSeconds();
  EXPECT_EQ(Refusal(bytes), "no error");
  EXPECT_LT(CpuSeconds() - start, 20.0);
}

TEST(HostileDicom, RejectsDeeplyNestedSequences)
{
  for (const DicomCoding coding : {DicomCoding::Explicit, DicomCoding::Implicit,
                                   DicomCoding::BigEndian, DicomCoding::Deflated})
  {
    for (const bool definedLengths : {false, true})
    {
      const std::string bytes =
          DicomFile(NestedDicomSequences(200000, coding, definedLengths), coding);
      EXPECT_TRUE(Contains(Refusal(bytes), "nests sequences too deeply"))
          << static_cast<int>(coding) << definedLengths;
      const TemporaryFolder folder;
      WriteAll(folder / "a.dcm", bytes);
      EXPECT_TRUE(Contains(MessageOf([&] { ReadVolume(folder / "a.dcm"); }), "too deeply"));
      EXPECT_TRUE(Contains(MessageOf([&] { ReadVolume(folder.Path()); }), "too deeply"));
    }
  }
}

TEST(HostileDicom, ReadsSequencesNestedFarDeeperThanRealOnes)
{
  ClaimedSegmentation claim;
  claim.MoreElements = DicomSequence(
      0x0062, 0x0002,
      {DicomShort(0x0062, 0x0004, 1) + NestedDicomSequences(50, DicomCoding::Explicit, false)});
  EXPECT_EQ(Refusal(ClaimedSegmentationBytes(claim)), "no error");
}

// Elements with descending tags, with other elements between them.
std::string FallingElements(int count, const std::string& vr, const std::string& value)
{
  std::string bytes = DicomShort(0x0028, 0x0002, 1);
  for (int i = count; i > 0; --i)
  {
    bytes += DicomElement(static_cast<std::uint16_t>(0x3000 + 2 * (i >> 12)),
                          static_cast<std::uint16_t>(2 * (i & 0xFFF)), vr, value);
    if (vr == "SQ")
    {
      bytes += DicomSequence(0x0008, static_cast<std::uint16_t>(i), {std::string()});
    }
  }
  return DicomFile(bytes);
}

// Creators of private elements and an equal number of private elements, in each of the groups.
std::string PrivateElements(int groups)
{
  std::string bytes;
  for (int group = 0; group < groups; ++group)
  {
    const auto number = static_cast<std::uint16_t>(0x0009 + 2 * group);
    std::string elements;
    for (int block = 0x10; block < 0xD8; ++block)
    {
      bytes += DicomElement(number, static_cast<std::uint16_t>(block), "LO", "c");
      elements += DicomElement(number, static_cast<std::uint16_t>(256 * block + 1), "LO", "x");
    }
    bytes += elements;
  }
  return bytes;
}

// The parser searches all earlier ones for each.
TEST(HostileDicom, RejectsTooManyElements)
{
  const std::string message = "has more than 5000 attributes";
  EXPECT_TRUE(Contains(Refusal(FallingElements(20000, "LO", "x")), message));
  EXPECT_TRUE(Contains(Refusal(DicomFile(PrivateElements(40))), message));
  EXPECT_TRUE(
      Contains(Refusal(DicomFile(DicomSequence(0x0008, 0x1140, {PrivateElements(40)}))), message));
}

// Regardless of the elements in between.
TEST(HostileDicom, CountsElementsBetweenSequences)
{
  EXPECT_TRUE(Contains(Refusal(FallingElements(20000, "SQ", "")), "has more than 5000 attributes"));
}

TEST(HostileDicom, ReadsManyElementsInManyItems)
{
  ClaimedSegmentation claim;
  const std::vector<std::string> items(20, PrivateElements(10));
  claim.MoreElements = DicomSequence(
      0x0062, 0x0002, {DicomShort(0x0062, 0x0004, 1) + DicomSequence(0x0062, 0x0008, items)});
  EXPECT_EQ(Refusal(ClaimedSegmentationBytes(claim)), "no error");
}

TEST(HostileDicom, RejectsGigabytesFromFewCompressedBytes)
{
  // A frame of 65,535 x 65,535 pixels in a stream of some bytes.
  const std::string item = std::string("\xFE\xFF\x00\xE0", 4);
  const std::string end = std::string("\xFE\xFF\xDD\xE0\0\0\0\0", 8);
  const std::string head =
      std::string("\xE0\x7F\x10\x00", 4) + "OB" + std::string("\0\0", 2) + std::string(4, '\xFF');
  const std::string pixels = head + item + std::string(4, '\0') + item +
                             std::string("\x08\0\0\0", 4) + std::string(8, '\1') + end;
  std::string bytes =
      DicomFile(DicomElement(0x0008, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.66.4") +
                DicomElement(0x0028, 0x0008, "IS", "1") + DicomShort(0x0028, 0x0010, 65535) +
                DicomShort(0x0028, 0x0011, 65535) + DicomShort(0x0028, 0x0100, 8) +
                DicomElement(0x0062, 0x0001, "CS", "LABELMAP") + pixels);
  const std::string native = "1.2.840.10008.1.2.1";
  // JPEG-LS; the lengths of the UID and of its group grow by three bytes and a padding byte.
  const std::string syntax = DicomElement(0x0002, 0x0010, "UI", "1.2.840.10008.1.2.4.80");
  const std::string old = DicomElement(0x0002, 0x0010, "UI", native);
  bytes.replace(bytes.find(old), old.size(), syntax);
  bytes[128 + 4 + 8] = static_cast<char>(syntax.size());
  EXPECT_TRUE(Contains(Refusal(bytes), "declares 4.29484 GB of pixels, but there are 8"));
}
} // namespace
} // namespace palpate::hostile_dicom_test
