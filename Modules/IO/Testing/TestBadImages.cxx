#include "BadImageFiles.h"
#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>

namespace palpate::bad_images_test
{
namespace
{
using namespace palpate::test;

// One sentence: it starts with the file, contains the fact and a fix, and no line break.
void ExpectMessage(const std::string& message, const std::filesystem::path& file,
                   const std::string& fact)
{
  EXPECT_EQ(message.rfind(file.string(), 0), 0u) << message;
  EXPECT_TRUE(Contains(message, fact));
  EXPECT_TRUE(Contains(message, "; "));
  EXPECT_EQ(message.back(), '.') << message;
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
}

// Output of the readers to the standard streams.
template <typename Action>
std::string Chatter(const Action& action)
{
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  action();
  return testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
}

void ExpectRefused(const std::vector<BadFile>& cases)
{
  for (const BadFile& bad : cases)
  {
    const TemporaryFolder folder;
    const auto file = folder / bad.Name;
    WriteAll(file, bad.Bytes);
    std::string asVolume;
    std::string asSegmentation;
    const std::string chatter = Chatter(
        [&]
        {
          asVolume = MessageOf([&] { ReadVolume(file); });
          asSegmentation = MessageOf([&] { ReadSegmentation(file); });
        });
    ExpectMessage(asVolume, file, bad.Fact);
    ExpectMessage(asSegmentation, file, bad.Fact);
    EXPECT_EQ(chatter, "") << bad.Name;
    EXPECT_EQ(folder.EntryCount(), 1u) << bad.Name;
  }
}

std::string SegmentationRefusal(const std::string& nrrd)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nrrd", nrrd);
  return MessageOf([&] { ReadSegmentation(folder / "a.nrrd"); });
}

TEST(BadImages, RejectsBadNiftiWithOneMessage)
{
  ExpectRefused(BadNiftiFiles());
}

TEST(BadImages, RejectsTruncatedOrMismatchedCompressedData)
{
  ExpectRefused(BadCompressedFiles());
}

TEST(BadImages, ReadsCompleteCompressedData)
{
  const TemporaryFolder folder;
  const std::string voxels = Noise(120000);
  WriteAll(folder / "a.nii.gz", Gzipped(LargeNifti()));
  WriteAll(folder / "a.mha", LargeMetaImage(Deflated(voxels)));
  WriteAll(folder / "b.mhd", LargeMetaImage("", "b.zraw"));
  WriteAll(folder / "b.zraw", Deflated(voxels));
  WriteAll(folder / "a.nrrd", LargeNrrd(Gzipped(voxels)));
  for (const char* name : {"a.nii.gz", "a.mha", "b.mhd", "a.nrrd"})
  {
    const auto image = ReadVolume(folder / name).Image;
    EXPECT_EQ(std::memcmp(image->GetScalarPointer(), voxels.data(), voxels.size()), 0) << name;
  }
}

TEST(BadImages, RejectsTruncatedDetachedCompressedData)
{
  const TemporaryFolder folder;
  const std::string packed = Deflated(Noise(120000));
  WriteAll(folder / "b.mhd", LargeMetaImage("", "b.zraw"));
  WriteAll(folder / "b.zraw", packed.substr(0, packed.size() / 2));
  EXPECT_TRUE(Contains(MessageOf([&] { ReadVolume(folder / "b.mhd"); }), "b.zraw is truncated"));
}

TEST(BadImages, RejectsBadNrrdWithOneMessage)
{
  ExpectRefused(BadNrrdFiles());
}

TEST(BadImages, RejectsOtherBadFilesWithOneMessage)
{
  ExpectRefused(BadOtherFiles());
}

TEST(BadImages, RejectsMissingFile)
{
  ExpectMessage(MessageOf([] { ReadVolume("/no/such/file.nii"); }), "/no/such/file.nii",
                "does not exist");
  ExpectMessage(MessageOf([] { ReadSegmentation("/no/such/file.nii"); }), "/no/such/file.nii",
                "does not exist");
}

TEST(BadImages, RejectsFolderWithoutImages)
{
  const TemporaryFolder folder;
  ExpectMessage(MessageOf([&] { ReadVolume(folder.Path()); }), folder.Path(), "no DICOM file");
  ExpectMessage(MessageOf([&] { ReadSegmentation(folder.Path()); }), folder.Path(),
                "holds 0 DICOM segmentation objects");
}

TEST(BadImages, RejectsFractionalLabels)
{
  EXPECT_TRUE(Contains(SegmentationRefusal(NrrdOfFloats(1.5F)), "it holds the value 1.5"));
}

TEST(BadImages, MessageShowsAlmostWholeLabelExactly)
{
  EXPECT_TRUE(Contains(SegmentationRefusal(NrrdOfFloats(0.998F)), "the value 0.998;"));
}

TEST(BadImages, RejectsNegativeLabels)
{
  std::vector<short> values(120, 1);
  values[5] = -3;
  EXPECT_TRUE(Contains(SegmentationRefusal(NrrdBytes(PlainNrrdLines("short"), BytesOf(values))),
                       "the negative value -3"));
}

TEST(BadImages, RejectsLabelsBeyondInt)
{
  std::vector<std::uint32_t> values(120, 1);
  values[5] = 3000000000U;
  EXPECT_TRUE(
      Contains(SegmentationRefusal(NrrdBytes(PlainNrrdLines("unsigned int"), BytesOf(values))),
               "holds the label 3000000000"));
}

TEST(BadImages, NamesCauseThatNrrdLibraryDoesNot)
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[7] = "encoding: bzip2";
  EXPECT_TRUE(Contains(SegmentationRefusal(NrrdBytes(lines, "BZh91AY&SY")), "compressed by bzip2"));
  lines = {"type: unsigned char",
           "dimension: 4",
           "space: left-posterior-superior",
           "sizes: 1 4 5 6",
           "space directions: none (2,0,0) (0,2,0) (0,0,2)",
           "encoding: raw"};
  EXPECT_TRUE(
      Contains(SegmentationRefusal(NrrdBytes(lines, std::string(120, '\1'))), "no \"kinds\""));
}

TEST(BadImages, RejectsEmptyMask)
{
  EXPECT_TRUE(Contains(
      SegmentationRefusal(NrrdBytes(PlainNrrdLines("unsigned char"), std::string(120, '\0'))),
      "has no labelled voxel"));
}
} // namespace
} // namespace palpate::bad_images_test
