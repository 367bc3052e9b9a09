#include "InputError.h"
#include "RandomShapes.h"
#include "Segmentation.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "Volume.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace palpate;
using namespace palpate::test;

// Damaged files must be read or refused; whatever else happens (a crash, another exception, an
// endless loop) fails the test program.
namespace
{
void ReadOrRefuse(const std::filesystem::path& file)
{
  try
  {
    ReadVolume(file);
  }
  catch (const InputError&)
  {
  }
  try
  {
    ReadSegmentation(file);
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

// Cuts the file at many lengths, then flips bytes, mostly among its first `headerBytes`.
void Fuzz(const std::string& name, const std::string& good, std::size_t headerBytes,
          unsigned int seed)
{
  const TemporaryFolder folder;
  const auto file = folder / name;
  Random random(seed);
  for (int cut = 0; cut < 60; ++cut)
  {
    Replace(file, good.substr(0, random() % good.size()));
    ReadOrRefuse(file);
  }
  for (int round = 0; round < 400; ++round)
  {
    std::string bytes = good;
    const auto flips = 1 + random() % 4;
    for (std::size_t flip = 0; flip < flips; ++flip)
    {
      const std::size_t range = round % 8 == 0 ? bytes.size() : std::min(headerBytes, bytes.size());
      bytes[random() % range] = static_cast<char>(random() % 256);
    }
    Replace(file, bytes);
    ReadOrRefuse(file);
  }
}

std::string Labels()
{
  return std::string(60, '\0') + std::string(30, '\1') + std::string(30, '\2');
}
} // namespace

TEST(ReaderFuzz, Nifti)
{
  Fuzz("a.nii", NiftiBytes({}, Labels()), 352, 1);
}

TEST(ReaderFuzz, CompressedNifti)
{
  const std::string bytes = Gzipped(NiftiBytes({}, Labels()));
  Fuzz("a.nii.gz", bytes, bytes.size(), 2);
}

TEST(ReaderFuzz, Nrrd)
{
  Fuzz("a.nrrd", NrrdBytes(PlainNrrdLines("unsigned char"), Labels()), 200, 3);
}

TEST(ReaderFuzz, CompressedNrrd)
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[7] = "encoding: gzip";
  Fuzz("a.nrrd", NrrdBytes(lines, Gzipped(Labels())), 260, 4);
}

TEST(ReaderFuzz, SlicerSegmentation)
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines.insert(lines.end(), {"Segment0_Name:=a", "Segment0_LabelValue:=1", "Segment0_Layer:=0",
                             "Segment0_Color:=1 0 0", "Segment1_Name:=b", "Segment1_LabelValue:=2",
                             "Segment1_Layer:=0"});
  Fuzz("a.seg.nrrd", NrrdBytes(lines, Labels()), 330, 5);
}

TEST(ReaderFuzz, MetaImage)
{
  Fuzz("a.mha", MetaImageBytes("MET_UCHAR", Labels()), 250, 6);
}

TEST(ReaderFuzz, DicomSlice)
{
  const TemporaryFolder folder;
  WriteDicomSlice(folder / "good", {});
  const std::string bytes = ReadAll(folder / "good");
  Fuzz("a.dcm", bytes, bytes.size(), 7);
}

TEST(ReaderFuzz, DicomSeriesOfDamagedSlices)
{
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i)
  {
    DicomSliceSpec spec;
    spec.PositionWorld = {0, 0, 2.0 * i};
    WriteDicomSlice(folder / (std::to_string(i) + ".dcm"), spec);
  }
  const std::string good = ReadAll(folder / "1.dcm");
  Random random(8);
  for (int round = 0; round < 300; ++round)
  {
    std::string bytes = good;
    bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    Replace(folder / "1.dcm", round % 5 == 0 ? bytes.substr(0, random() % bytes.size()) : bytes);
    ReadOrRefuse(folder.Path());
  }
}

TEST(ReaderFuzz, DicomSegmentation)
{
  const TemporaryFolder folder;
  DicomSegmentationSpec spec;
  spec.Segments = {{1, "a"}, {2, "b"}};
  spec.Frames = {{1, 0.0, std::vector<int>(12, 1)}, {2, 6.0, std::vector<int>(12, 1)}};
  WriteDicomSegmentation(folder / "good", spec);
  const std::string bytes = ReadAll(folder / "good");
  Fuzz("a.dcm", bytes, bytes.size(), 9);
}
