#include "AddressSpaceLimit.h"
#include "BadImageFiles.h"
#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include "vtkMatrix3x3.h"

#include <cstring>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace palpate::hostile_images_test
{
namespace
{
using namespace palpate::test;

// Memory and time are bounded by the actual content of an image file, not by its header.
constexpr rlim_t SomeMemory = rlim_t{1} << 30; // limit for reading a file of some bytes
constexpr std::size_t Gigabytes = std::size_t{3} << 30;

class HostileImages : public testing::Test
{
protected:
  std::string Refusal(const std::string& name, const std::string& bytes) const
  {
    WriteAll(this->Folder / name, bytes);
    const AddressSpaceLimit limit(SomeMemory);
    return MessageOf([&] { ReadVolume(this->Folder / name); });
  }
  std::string NrrdRefusal(std::vector<std::string> lines) const
  {
    return this->Refusal("a.nrrd", NrrdBytes(lines, std::string(120, '\1')));
  }
  // The plain header with one more line.
  std::string NrrdRefusalWith(const std::string& line) const
  {
    std::vector<std::string> lines = PlainNrrdLines("unsigned char");
    lines.push_back(line);
    return this->NrrdRefusal(lines);
  }

  TemporaryFolder Folder;
};

// Gzip data of these bytes followed by this many zeros; some megabytes.
std::string GzippedWithZerosBehind(const std::string& bytes)
{
  // Gzip members follow each other, so the zeros are compressed once per 64 MB.
  const std::string zeros = Gzipped(std::string(std::size_t{64} << 20, '\0'));
  std::string packed = Gzipped(bytes);
  for (std::size_t behind = 0; behind < Gigabytes; behind += std::size_t{64} << 20)
  {
    packed += zeros;
  }
  return packed;
}

TEST_F(HostileImages, RejectsNrrdFieldsThatOverflowLibrary)
{
  for (const std::size_t letters : {1000U, 5000U, 100000U, 2000000U})
  {
    const std::string word(letters, 'x');
    for (const char* field : {"type: ", "encoding: ", "endian: ", "space: ", "space directions: (",
                              "kinds: ", "centers: ", "no such field: ", "byte skip: ", ""})
    {
      EXPECT_TRUE(Contains(this->NrrdRefusalWith(field + word), "one of its lines has"))
          << field << letters;
    }
  }
}

TEST_F(HostileImages, ReadsLongKeyValuePairsAndComments)
{
  EXPECT_EQ(this->NrrdRefusalWith("note:=" + std::string(100000, 'x') + ": y"), "no error");
  EXPECT_EQ(this->NrrdRefusalWith("# " + std::string(100000, 'x')), "no error");
}

// The library ends a line there too, and parses the rest as a field.
TEST_F(HostileImages, RejectsLongNrrdLinesAfterCarriageReturn)
{
  EXPECT_TRUE(Contains(this->NrrdRefusalWith("note:=a\r" + std::string(2000, 'x')),
                       "one of its lines has 2000 characters"));
}

TEST_F(HostileImages, FollowsNrrdSpaceAfterCarriageReturn)
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[2] = "note:=a\rspace: right-anterior-superior";
  WriteAll(this->Folder / "a.nrrd", NrrdBytes(lines, std::string(120, '\1')));
  const Volume volume = ReadVolume(this->Folder / "a.nrrd");
  // To the right and to the front are the negative directions of LPS.
  EXPECT_EQ(volume.Image->GetOrigin()[0], -10.0);
  EXPECT_EQ(volume.Image->GetOrigin()[1], -20.0);
  EXPECT_EQ(volume.Image->GetDirectionMatrix()->GetElement(0, 0), -1.0);
}

// For the library, a line ends at a null byte.
TEST_F(HostileImages, RejectsNrrdLinesWithNullBytes)
{
  WriteAll(this->Folder / "-", std::string(120, '\1'));
  EXPECT_TRUE(Contains(this->NrrdRefusalWith(std::string("data file: -\0", 13)), "a null byte"));
}

TEST_F(HostileImages, RejectsNrrdSizesThatOverflow)
{
  for (const char* sizes : {"4294967297 5 6", "4 5 -6", "4 5 18446744073709551615", "4 5 0"})
  {
    std::vector<std::string> lines = PlainNrrdLines("unsigned char");
    lines[3] = std::string("sizes: ") + sizes;
    EXPECT_TRUE(Contains(this->NrrdRefusal(lines), "damaged header")) << sizes;
  }
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[3] = "sizes: 2147483647 2147483647 2147483647";
  EXPECT_TRUE(Contains(this->NrrdRefusal(lines), "header"));
}

TEST_F(HostileImages, RejectsNrrdAxesThatOverflowLibrary)
{
  std::string sizes = "sizes:";
  for (int axis = 0; axis < 17; ++axis)
  {
    sizes += " 2";
  }
  EXPECT_TRUE(
      Contains(this->NrrdRefusal({"type: unsigned char", "dimension: 16", sizes, "encoding: raw"}),
               "has 16 dimensions"));
}

// The library takes such an axis for components, and allocates space only for the other two.
TEST_F(HostileImages, RejectsNrrdDirectionsOfComponents)
{
  const std::vector<std::string> lines{
      "type: unsigned char", "dimension: 3",  "space: left-posterior-superior",
      "sizes: 3 4 5",        "encoding: raw", "space directions: (1,0,0) (0,1,0) (0,0,1)"};
  for (const char* kinds : {"vector domain domain", "space RGB-color space", "space space List"})
  {
    std::vector<std::string> withKinds = lines;
    withKinds.push_back(std::string("kinds: ") + kinds);
    EXPECT_TRUE(Contains(this->NrrdRefusal(withKinds), "whose kind is not spatial")) << kinds;
  }
}

TEST_F(HostileImages, RejectsNrrdDataFilePatterns)
{
  for (const char* pattern : {"%s 1 2 1", "%n%n 1 2 1", "%999999999d 1 2 1", "a%03d.raw 1 9 1"})
  {
    EXPECT_TRUE(Contains(this->NrrdRefusalWith(std::string("data file: ") + pattern),
                         "names its data files by a pattern"));
  }
}

TEST_F(HostileImages, RejectsNrrdDataFilesThatAreNotRegular)
{
  mkfifo((this->Folder / "pipe").c_str(), 0600);
  for (const char* name : {"pipe", "-", ".", "/dev/zero"})
  {
    EXPECT_TRUE(Contains(this->NrrdRefusalWith(std::string("data file: ") + name),
                         "that is not a regular file"))
        << name;
  }
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines.emplace_back("data file: LIST\npipe");
  EXPECT_TRUE(Contains(this->NrrdRefusal(lines), "that is not a regular file"));
  lines.back() = "data file: LIST\n" + std::string(3000, 'x');
  EXPECT_TRUE(Contains(this->NrrdRefusal(lines), "one of its lines has 3000 characters"));
}

TEST_F(HostileImages, RejectsTooManyKeyValuePairs)
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  for (int pair = 0; pair < 200000; ++pair)
  {
    lines.push_back("k" + std::to_string(pair) + ":=v");
  }
  EXPECT_TRUE(Contains(this->NrrdRefusal(lines), "more than 20000 key/value pairs"));
}

TEST_F(HostileImages, RejectsMetaImageKeysThatOverflowLibrary)
{
  for (const std::size_t letters : {100U, 300U, 3000U})
  {
    for (const std::string& key : {"ElementType" + std::string(letters, 'E'),
                                   std::string(letters, 'x'), std::string(letters, ' ') + "x"})
    {
      const std::string bytes = MetaImageBytes(
          "MET_UCHAR", std::string(120, '\1'),
          "TransformMatrix = 1 0 0 0 1 0 0 0 1\nElementSpacing = 2 2 2\n" + key + " = MET_UCHAR\n");
      EXPECT_TRUE(Contains(this->Refusal("a.mha", bytes), "is not a MetaImage file")) << key;
    }
  }
}

TEST_F(HostileImages, IgnoresHugeFilesNextToLabelMap)
{
  WriteAll(this->Folder / "a.nii", NiftiBytes({}, std::string(120, '\1')));
  // Lists of one line that would fill the memory.
  for (const char* name : {"a.nii.txt", "a.nii.lut"})
  {
    WriteAll(this->Folder / name, "");
    std::filesystem::resize_file(this->Folder / name, Gigabytes);
  }
  const AddressSpaceLimit limit(SomeMemory);
  const Segmentation segmentation = ReadSegmentation(this->Folder / "a.nii");
  ASSERT_FALSE(segmentation.Notes.empty());
  EXPECT_TRUE(Contains(segmentation.Notes.back(), "is not a list of label names"));
}

TEST_F(HostileImages, RejectsTooManyLayers)
{
  const std::string bytes =
      NrrdBytes({"type: unsigned char", "dimension: 4", "sizes: 100000 2 2 2",
                 "kinds: list domain domain domain", "encoding: raw", "Segment0_Name:=a"},
                std::string(800000, '\1'));
  WriteAll(this->Folder / "a.seg.nrrd", bytes);
  EXPECT_TRUE(Contains(MessageOf([&] { ReadSegmentation(this->Folder / "a.seg.nrrd"); }),
                       "has 100000 layers of segments"));
}

TEST_F(HostileImages, RejectsGigabytesAfterVoxels)
{
  const std::string nifti = GzippedWithZerosBehind(NiftiBytes({}, std::string(120, '\1')));
  EXPECT_TRUE(Contains(this->Refusal("a.nii.gz", nifti), "go on for more than a megabyte"));
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[7] = "encoding: gzip";
  // One member, which is what this library decodes.
  const std::string packed = Gzipped(std::string(std::size_t{64} << 20, '\1'));
  EXPECT_TRUE(Contains(this->Refusal("a.nrrd", NrrdBytes(lines, packed)),
                       "go on for more than a megabyte"));
  EXPECT_TRUE(Contains(
      this->Refusal("a.mha", LargeMetaImage(Deflated(std::string(std::size_t{64} << 20, '\1')))),
      "go on for more than a megabyte"));
}

TEST_F(HostileImages, RejectsVoxelsThatExceedCompressedBytes)
{
  for (const char* encoding : {"raw", "gzip", "hex", "ascii"})
  {
    std::vector<std::string> lines = PlainNrrdLines("unsigned char");
    lines[3] = "sizes: 2000 2000 2000";
    lines[7] = std::string("encoding: ") + encoding;
    EXPECT_TRUE(Contains(this->NrrdRefusal(lines), "is truncated")) << encoding;
  }
}
} // namespace
} // namespace palpate::hostile_images_test
