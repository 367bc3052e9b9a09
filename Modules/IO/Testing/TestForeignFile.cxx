#include "ForeignFile.h"

#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SurfaceFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include <gtest/gtest.h>
#include <vector>

namespace palpate::foreign_file_test
{
namespace
{
using namespace palpate::test;

struct Foreign
{
  const char* Name;
  std::string Bytes;
  const char* Is;
  const char* Remedy;
};

std::vector<Foreign> ForeignFiles()
{
  return {
      {"a.IMG", std::string(400, '\1'), "has voxels without a header", ".hdr"},
      {"a.img.gz", Gzipped("abc"), "has voxels without a header", ".hdr"},
      {"a.vtk", "# vtk DataFile Version 3.0\n", "is a legacy VTK file", "NIfTI-1"},
      {"image.vti", "<VTKFile type=\"ImageData\">", "is a VTK image", "convert"},
      {"surface.vtp", "<VTKFile type=\"PolyData\">", "is a surface, not an image", "voxels"},
      {"a.stl", "solid a", "is a surface, not an image", "commands that take them"},
      {"model.json", "{}", "is a JSON file", "image"},
      {"image.raw", "abc", "has voxels without a header", ".mhd"},
      {"page.nii.gz", "<!DOCTYPE html><p>404", "is a web page", "download"},
      {"page.mha", "<html>", "is a web page", "download"},
      {"page.nrrd", "<html>", "is a web page", "download"},
      {"page", "<html>", "is a web page", "download"},
      {"mask.zip", "PK\x03\x04 and more", "is a ZIP archive", "unpack"},
      {"mask.nii.gz", "PK\x03\x04 and more", "is a ZIP archive", "unpack"},
      {"mask.tar.gz", Gzipped("mask.nii"), "is an archive", "unpack"},
      {"picture.png", "\x89PNG\r\n", "is a PNG image", "volume"},
      {"picture.nii", "\xFF\xD8\xFF\xE0", "is a JPEG image", "volume"},
      {"empty.png", "", "is empty", "again"},
      {"letter.docx", "a letter", "is not in a known image format", ".nii.gz"},
  };
}

TEST(ForeignFile, RejectsNamingFormatAndFix)
{
  for (const Foreign& foreign : ForeignFiles())
  {
    const TemporaryFolder folder;
    const auto file = folder / foreign.Name;
    WriteAll(file, foreign.Bytes);
    for (const std::string& message :
         {MessageOf([&] { ReadVolume(file); }), MessageOf([&] { ReadSegmentation(file); })})
    {
      EXPECT_EQ(message.rfind(file.string() + " ", 0), 0U) << message;
      EXPECT_TRUE(Contains(message, foreign.Is));
      EXPECT_TRUE(Contains(message.substr(message.find("; ") + 1), foreign.Remedy));
    }
  }
}

TEST(ForeignFile, LeavesDamagedKnownFormatsToTheirReaders)
{
  const TemporaryFolder folder;
  const std::vector<std::pair<const char*, std::string>> files{
      {"a.nii", NiftiBytes({}).substr(0, 360)},
      {"a.nii.gz", Gzipped(NiftiBytes({}).substr(0, 360))},
      {"a.nrrd", "NRRD0004\ntype: nonsense\n\n"},
      {"a.mha", "ObjectType = Image\nNDims = x\n"}};
  for (const auto& [name, bytes] : files)
  {
    const std::filesystem::path file = folder / name;
    WriteAll(file, bytes);
    EXPECT_TRUE(Contains(MessageOf([&] { ReadVolume(file); }), "; copy or export it again."))
        << name;
  }
}

TEST(ForeignFile, HeaderReportsMissingData)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nhdr", "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n"
                              "data file: a.raw\n");
  WriteAll(folder / "a.mhd", "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\n"
                             "ElementType = MET_UCHAR\nElementDataFile = b.raw\n");
  EXPECT_TRUE(Contains(MessageOf([&] { ReadVolume(folder / "a.nhdr"); }), "a.raw"));
  EXPECT_TRUE(Contains(MessageOf([&] { ReadVolume(folder / "a.nhdr"); }), "lacks its data file"));
  EXPECT_TRUE(Contains(MessageOf([&] { ReadVolume(folder / "a.mhd"); }), "lacks its data file"));
}
} // namespace
} // namespace palpate::foreign_file_test
