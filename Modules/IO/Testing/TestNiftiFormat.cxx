#include "MessageOf.h"
#include "SegmentationFile.h"
#include "StoredImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cstring>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::nifti_format_test
{
namespace
{
using namespace palpate::test;

NiftiSpec Shorts()
{
  NiftiSpec spec;
  spec.Type = 4;
  spec.Bits = 16;
  return spec;
}

Volume ReadPair(const std::string& name, const std::string& header, const std::string& dataName,
                const std::string& voxels)
{
  const TemporaryFolder folder;
  WriteAll(folder / name, header);
  WriteAll(folder / dataName, voxels);
  return ReadVolume(folder / name);
}

std::string PairRefusal(const std::string& header, const std::string& voxels)
{
  return MessageOf([&] { ReadPair("a.hdr", header, "a.img", voxels); });
}

void ExpectSpecified(const Volume& volume)
{
  Vector3 world;
  volume.Image->TransformIndexToPhysicalPoint(3, 4, 5, world.data());
  EXPECT_EQ(world, Vector3(-16, -28, 40));
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(3, 4, 5, 0), 119.0);
  EXPECT_TRUE(volume.Notes.empty());
}

std::string ThreeVolumes()
{
  return std::string(120, '\1') + std::string(120, '\2') + std::string(120, '\3');
}

NiftiSpec FourDimensional(short volumes)
{
  NiftiSpec spec;
  spec.Dimensions = {4, 4, 5, 6, volumes, 1, 1, 1};
  return spec;
}

TEST(NiftiFormat, ReadsSecondVersionInBothByteOrders)
{
  const std::string bytes = Nifti2Bytes(Shorts(), BytesOf(Counting<short>(120)));
  ExpectSpecified(ReadBytes("a.nii", bytes));
  ExpectSpecified(ReadBytes("a.nii.gz", Gzipped(bytes)));
  ExpectSpecified(ReadBytes("a.nii", ReversedNifti2(bytes, 2)));
}

TEST(NiftiFormat, SecondVersionKeepsDoublePrecision)
{
  std::string bytes = Nifti2Bytes({}, std::string(120, '\1'));
  const double offset = 10.123456789012345;
  std::memcpy(&bytes[400 + 8 * 3], &offset, sizeof offset);
  EXPECT_EQ(ReadBytes("a.nii", bytes).Image->GetOrigin()[0], -offset);
}

TEST(NiftiFormat, SecondVersionHasSlopeAndQForm)
{
  NiftiSpec spec;
  spec.SFormCode = 0;
  spec.QFormCode = 1;
  spec.Slope = 0.5F;
  spec.Intercept = -3;
  const Volume volume =
      ReadBytes("a.nii", Nifti2Bytes(spec, BytesOf(Counting<unsigned char>(120))));
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(3, 4, 5, 0), 119 * 0.5 - 3.0);
  Vector3 world;
  volume.Image->TransformIndexToPhysicalPoint(3, 4, 5, world.data());
  EXPECT_EQ(world, Vector3(-16, -28, 40));
}

TEST(NiftiFormat, RejectsSecondVersionTruncatedAnywhere)
{
  ExpectTruncationsAreRefused("a.nii", Nifti2Bytes({}, std::string(120, '\1')));
}

TEST(NiftiFormat, RejectsSecondVersionOfAbsurdSizes)
{
  for (const std::int64_t size : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{1} << 31,
                                  std::numeric_limits<std::int64_t>::max()})
  {
    std::string bytes = Nifti2Bytes({}, std::string(120, '\1'));
    std::memcpy(&bytes[16 + 8 * 2], &size, sizeof size);
    EXPECT_TRUE(Contains(RefusalOf("a.nii", bytes), "voxels along axis 2"));
  }
  std::string bytes = Nifti2Bytes({}, std::string(120, '\1'));
  for (std::size_t axis = 1; axis <= 3; ++axis)
  {
    const std::int64_t size = std::numeric_limits<int>::max();
    std::memcpy(&bytes[16 + 8 * axis], &size, sizeof size);
  }
  EXPECT_TRUE(Contains(RefusalOf("a.nii", bytes), "has a damaged header"));
}

TEST(NiftiFormat, ReadsPairsInBothByteOrders)
{
  const std::string header = NiftiPairHeader(Shorts());
  const std::string voxels = BytesOf(Counting<short>(120));
  const std::string swapped = BigEndian(Counting<short>(120));
  ExpectSpecified(ReadPair("a.hdr", header, "a.img", voxels));
  ExpectSpecified(ReadPair("a.hdr", header, "a.img.gz", Gzipped(voxels)));
  ExpectSpecified(ReadPair("a.hdr.gz", Gzipped(header), "a.img.gz", Gzipped(voxels)));
  ExpectSpecified(ReadPair("a.b.hdr.gz", Gzipped(header), "a.b.img", voxels));
  ExpectSpecified(ReadPair("A.HDR", header, "A.IMG", voxels));
  ExpectSpecified(ReadPair("a.hdr", ReversedNifti1(header, 2), "a.img", swapped));
}

TEST(NiftiFormat, PairsOfSecondVersion)
{
  std::string header = Nifti2Bytes({}, "").substr(0, 540);
  header.replace(4, 3, "ni2");
  const std::int64_t start = 0;
  std::memcpy(&header[168], &start, sizeof start);
  ExpectSpecified(ReadPair("a.hdr", header, "a.img", BytesOf(Counting<unsigned char>(120))));
}

TEST(NiftiFormat, AnalyzeIsTakenAsLpsWithNote)
{
  const std::string voxels = BytesOf(Counting<short>(120));
  NiftiSpec spec = Shorts();
  spec.PixelDimensions = {0, 1.5F, 2, 3};
  spec.Dimensions = {4, 4, 5, 6, 0, 0, 0, 0}; // an unused fourth axis
  const Volume volume = ReadPair("a.hdr", AnalyzeHeader(spec), "a.img", voxels);
  Vector3 world;
  volume.Image->TransformIndexToPhysicalPoint(3, 4, 5, world.data());
  EXPECT_EQ(world, Vector3(4.5, 8, 15));
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(3, 4, 5, 0), 119.0);
  ASSERT_EQ(volume.Notes.size(), 1u);
  EXPECT_TRUE(Contains(volume.Notes[0], "no reliable orientation"));
  const Volume other = ReadPair("a.hdr", ReversedNifti1(AnalyzeHeader(spec), 2), "a.img",
                                BigEndian(Counting<short>(120)));
  EXPECT_EQ(other.Image->GetScalarComponentAsDouble(3, 4, 5, 0), 119.0);
}

TEST(NiftiFormat, LabelsOfPairAreRead)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.hdr", AnalyzeHeader({}));
  WriteAll(folder / "a.img", std::string(60, '\0') + std::string(60, '\7'));
  EXPECT_EQ(ReadSegmentation(folder / "a.hdr").Segments.at(0).Label, 7);
}

TEST(NiftiFormat, RejectsPairsTruncatedAnywhere)
{
  const std::string voxels(120, '\1');
  for (const std::string& header : {NiftiPairHeader({}), AnalyzeHeader({})})
  {
    for (std::size_t length = 1; length < header.size(); ++length)
    {
      EXPECT_NE(PairRefusal(header.substr(0, length), voxels), "no error") << length;
    }
    for (std::size_t length = 0; length < voxels.size(); ++length)
    {
      EXPECT_NE(PairRefusal(header, voxels.substr(0, length)), "no error") << length;
    }
  }
}

TEST(NiftiFormat, RejectsPairsWithoutDataFile)
{
  EXPECT_TRUE(Contains(RefusalOf("a.hdr", NiftiPairHeader({})), "lacks its data file, a.img"));
}

TEST(NiftiFormat, RejectsDataFilesThatAreNotRegular)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.hdr", NiftiPairHeader({}));
  std::filesystem::create_symlink("/dev/zero", folder / "a.img");
  EXPECT_TRUE(Contains(MessageOf([&] { ReadVolume(folder / "a.hdr"); }), "lacks its data file"));
}

TEST(NiftiFormat, RejectsSingleFilesWithEndingOfOtherKind)
{
  EXPECT_TRUE(Contains(PairRefusal(NiftiBytes({}), ""), "is not the header of a pair of files"));
  EXPECT_TRUE(Contains(RefusalOf("a.nii", NiftiPairHeader({}) + std::string(200, '\0')),
                       "is the header of a pair of files"));
  EXPECT_TRUE(Contains(PairRefusal("#?RADIANCE\n" + std::string(400, ' '), ""), "is not a NIfTI"));
}

TEST(NiftiFormat, VolumeIsChosenByNumber)
{
  const std::string bytes = NiftiBytes(FourDimensional(3), ThreeVolumes());
  for (int number = 1; number <= 3; ++number)
  {
    const VolumeChoice choice{std::to_string(number)};
    for (const Volume& volume :
         {ReadBytes("a.nii", bytes, choice), ReadBytes("a.nii.gz", Gzipped(bytes), choice)})
    {
      EXPECT_EQ(volume.Image->GetPointData()->GetScalars()->GetRange()[0], number);
      EXPECT_EQ(volume.Image->GetPointData()->GetScalars()->GetRange()[1], number);
    }
  }
}

TEST(NiftiFormat, SegmentationIsChosenByNumber)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nii", NiftiBytes(FourDimensional(3), ThreeVolumes()));
  const Segmentation second = ReadSegmentation(folder / "a.nii", VolumeChoice{"2"});
  ASSERT_EQ(second.Segments.size(), 1u);
  EXPECT_EQ(second.Segments[0].Label, 2);
}

TEST(NiftiFormat, RefusalSaysHowToChooseVolume)
{
  const std::string bytes = NiftiBytes(FourDimensional(3), ThreeVolumes());
  EXPECT_TRUE(Contains(RefusalOf("a.nii", bytes),
                       "holds 3 volumes; choose one by its number, from 1 to 3 (--series)"));
  for (const char* wrong : {"0", "4", "-1", "x", "1.5", "99999999999"})
  {
    EXPECT_TRUE(Contains(MessageOf([&] { ReadBytes("a.nii", bytes, {wrong}); }),
                         "holds 3 volumes, but none of this number"))
        << wrong;
  }
}

TEST(NiftiFormat, ChoiceIsIgnoredForOneVolume)
{
  EXPECT_EQ(ReadBytes("a.nii", NiftiBytes({}), {"1.2.840"}).Image->GetDimensions()[2], 6);
}

// Volumes behind the chosen one are decoded, so that their damage is noticed.
TEST(NiftiFormat, RejectsDamageBehindChosenVolume)
{
  const std::string packed = Gzipped(NiftiBytes(FourDimensional(3), ThreeVolumes()));
  EXPECT_TRUE(Contains(
      MessageOf([&] { ReadBytes("a.nii.gz", packed.substr(0, packed.size() - 6), {"1"}); }),
      "is truncated"));
}
// A header's mark of extensions, one of them of `size` bytes, and the voxels.
std::string WithExtension(std::int32_t size, float voxelOffset, std::int32_t code = 6)
{
  std::string bytes = NiftiBytes({});
  const std::string voxels(120, '\5');
  std::string extension = BytesOf(std::vector<std::int32_t>{size, code});
  extension.resize(32, '\0');
  bytes.resize(348);
  bytes.replace(108, 4, BytesOf(std::vector<float>{voxelOffset}));
  return bytes + std::string("\1\0\0\0", 4) + extension + voxels;
}

TEST(NiftiFormat, RejectsVoxelsThatStartWithinExtension)
{
  for (const float offset : {352.0F, 360.0F, 0.0F})
  {
    EXPECT_TRUE(Contains(MessageOf([&] { ReadBytes("a.nii", WithExtension(32, offset)); }),
                         "start within an extension of its header"))
        << offset;
  }
  const Volume behind = ReadBytes("a.nii", WithExtension(32, 384.0F));
  EXPECT_EQ(behind.Image->GetScalarComponentAsDouble(0, 0, 0, 0), 5.0);
  EXPECT_TRUE(behind.Notes.empty());
}

// The mark alone, or voxels that look like an odd block, are no extension.
TEST(NiftiFormat, MarkWithoutExtensionIsIgnored)
{
  for (const auto& [size, code] :
       std::vector<std::pair<std::int32_t, std::int32_t>>{{0, 0}, {33, 6}, {32, 7}, {-16, 6}})
  {
    EXPECT_EQ(ReadBytes("a.nii", WithExtension(size, 384.0F, code))
                  .Image->GetScalarComponentAsDouble(0, 0, 0, 0),
              5.0);
  }
}

// Without a start of its voxels a file has them behind the mark.
TEST(NiftiFormat, NotesVoxelsThatStartWithinHeader)
{
  std::string voxels(120, '\1');
  voxels[0] = '\7';
  std::string bytes = NiftiBytes({}, voxels);
  bytes.replace(108, 4, BytesOf(std::vector<float>{0.0F}));
  const Volume volume = ReadBytes("a.nii", bytes);
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(0, 0, 0, 0), 7.0);
  ASSERT_EQ(volume.Notes.size(), 1u);
  EXPECT_TRUE(Contains(volume.Notes[0], "read from byte 352"));
}
} // namespace
} // namespace palpate::nifti_format_test
