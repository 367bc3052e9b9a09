#include "ForeignFile.h"

#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SurfaceFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include <gtest/gtest.h>
#include <vector>

using namespace palpate;
using namespace palpate::test;

namespace
{
// A NIfTI header of a pair: the mark says that the voxels lie in another file.
std::string PairHeader()
{
  std::string bytes = NiftiBytes({}).substr(0, 352);
  bytes.replace(344, 3, "ni1");
  return bytes;
}

std::string AnalyzeHeader()
{
  std::string bytes = NiftiBytes({}).substr(0, 348);
  bytes.replace(344, 4, std::string(4, '\0'));
  return bytes;
}

std::string TarOf(const std::string& content)
{
  std::string bytes = content;
  bytes.resize(1024, '\0');
  bytes.replace(257, 5, "ustar");
  return bytes;
}

const std::string LegacySurface =
    "# vtk DataFile Version 3.0\nprostate\nASCII\nDATASET POLYDATA\nPOINTS 0 float\n";
const std::string LegacyImage =
    "# vtk DataFile Version 3.0\nprostate\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 1 1 1\n";

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
      {"a.hdr", PairHeader(), "is the header of a NIfTI pair", ".nii.gz"},
      {"pair.nii", PairHeader(), "is the header of a NIfTI pair", ".nii.gz"},
      {"b.hdr", AnalyzeHeader(), "is an Analyze 7.5 header", "left and right"},
      {"analyze.nii", AnalyzeHeader(), "is an Analyze 7.5 header", "left and right"},
      {"a.img", std::string(400, '\1'), "voxels of a pair (.hdr and .img)", ".nii.gz"},
      {"surface.vtk", LegacySurface, "is a legacy VTK file (POLYDATA), a surface", ".vtp"},
      {"image.vtk", LegacyImage, "is a legacy VTK file (STRUCTURED_POINTS), an image", "convert"},
      {"surface.vtp", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">", "is a VTK surface",
       "voxels"},
      {"image.vti", "<VTKFile type=\"ImageData\">", "is a VTK file (IMAGEDATA)", "convert"},
      {"a.mgz", Gzipped(std::string(300, '\0')), "is a FreeSurfer volume", "mri_convert"},
      {"a.stl", "solid a", "is a surface, not an image", "commands that take them"},
      {"model.json", "{}", "is a JSON file", "image"},
      {"image.raw", "abc", "has voxels without a header", ".mhd"},
      {"page.nii.gz", "<!DOCTYPE html><p>404", "is a web page", "download"},
      {"mask.zip", "PK\x03\x04 and more", "is a ZIP archive", "unpack"},
      {"mask.nii.gz", Gzipped(TarOf("mask.nii")), "is a gzip file, and its content is a tar",
       "gunzip"},
      {"mask.nrrd.gz", Gzipped("NRRD0004\ntype: short\n"), "its content is an NRRD file", "gunzip"},
      {"mask.gz", Gzipped("nothing that is known"), "is a gzip file whose content", "gunzip"},
      {"named.gz", Gzipped(NiftiBytes({})), "is a NIfTI file by content", "end in .nii.gz"},
      {"mask", NiftiBytes({}), "is a NIfTI file by content", "end in .nii"},
      {"mask.nii", "NRRD0004\ntype: short\n", "is an NRRD file by content", "end in .nrrd"},
      {"picture.png", "\x89PNG\r\n", "is a PNG image", "volume"},
      {"text.mha", "<html>", "is a web page", "download"},
      {"text.nrrd", "<html>", "is a web page", "download"},
  };
}
} // namespace

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
    WriteAll(folder / name, bytes);
    EXPECT_FALSE(RecognizeForeignFile(folder / name).has_value()) << name;
  }
}

TEST(ForeignFile, RejectsLegacyVtkSurface)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.vtk", LegacySurface);
  EXPECT_TRUE(Contains(MessageOf([&] { ReadSurface(folder / "a.vtk"); }),
                       "is a legacy VTK file (POLYDATA), a surface; save it as .vtp"));
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
