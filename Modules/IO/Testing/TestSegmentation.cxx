#include "ImageGrid.h"
#include "InputError.h"
#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "TestData.h"

#include "vtkPointData.h"

#include <Eigen/LU>

#include <fstream>
#include <gtest/gtest.h>

namespace palpate::segmentation_test
{
namespace
{
using namespace palpate::test;

template <typename T>
Segmentation ReadNrrdOf(const char* type, const std::vector<T>& values)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nrrd", NrrdBytes(PlainNrrdLines(type), BytesOf(values)));
  return ReadSegmentation(folder / "a.nrrd");
}

// 120 voxels of which the last has a label.
template <typename T>
std::vector<T> OneVoxel(T label)
{
  std::vector<T> values(120, T(0));
  values.back() = label;
  return values;
}

double ValueOf(const Segmentation& segmentation, std::size_t layer, int voxel)
{
  return segmentation.Layers[layer]->GetPointData()->GetScalars()->GetTuple1(voxel);
}

// Header lines of a Slicer segmentation on the plain 4 x 5 x 6 grid with this many layers.
std::vector<std::string> SlicerLines(int layers, const std::vector<std::string>& keys)
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  if (layers > 1)
  {
    lines[1] = "dimension: 4";
    lines[3] = "sizes: " + std::to_string(layers) + " 4 5 6";
    lines[4] = "space directions: none (2,0,0) (0,2,0) (0,0,2)";
    lines[5] = "kinds: list domain domain domain";
  }
  lines.insert(lines.end(), keys.begin(), keys.end());
  return lines;
}

Segmentation ReadSlicer(const std::vector<std::string>& lines, const std::string& voxels,
                        LeftHandedAxes leftHanded = LeftHandedAxes::Reverse)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.seg.nrrd", NrrdBytes(lines, voxels));
  return ReadSegmentation(folder / "a.seg.nrrd", leftHanded);
}

TEST(Segmentation, LayersHaveSmallestSufficientType)
{
  EXPECT_EQ(ReadNrrdOf("unsigned char", OneVoxel<unsigned char>(255)).Layers[0]->GetScalarType(),
            VTK_UNSIGNED_CHAR);
  EXPECT_EQ(ReadNrrdOf("short", OneVoxel<short>(255)).Layers[0]->GetScalarType(),
            VTK_UNSIGNED_CHAR);
  EXPECT_EQ(ReadNrrdOf("int", OneVoxel<int>(256)).Layers[0]->GetScalarType(), VTK_UNSIGNED_SHORT);
  EXPECT_EQ(ReadNrrdOf("double", OneVoxel<double>(65535)).Layers[0]->GetScalarType(),
            VTK_UNSIGNED_SHORT);
  EXPECT_EQ(ReadNrrdOf("unsigned int", OneVoxel<unsigned int>(65536)).Layers[0]->GetScalarType(),
            VTK_INT);
}

TEST(Segmentation, KeepsLabelsOfEveryIntegerAndFloatType)
{
  const auto expect = [](const Segmentation& segmentation)
  {
    ASSERT_EQ(segmentation.Segments.size(), 1u);
    EXPECT_EQ(segmentation.Segments[0].Label, 100);
    EXPECT_EQ(segmentation.Segments[0].Value, 100);
    EXPECT_EQ(ValueOf(segmentation, 0, 119), 100);
    EXPECT_EQ(ValueOf(segmentation, 0, 0), 0);
  };
  expect(ReadNrrdOf("signed char", OneVoxel<signed char>(100)));
  expect(ReadNrrdOf("unsigned char", OneVoxel<unsigned char>(100)));
  expect(ReadNrrdOf("short", OneVoxel<short>(100)));
  expect(ReadNrrdOf("unsigned short", OneVoxel<unsigned short>(100)));
  expect(ReadNrrdOf("int", OneVoxel<int>(100)));
  expect(ReadNrrdOf("unsigned int", OneVoxel<unsigned int>(100)));
  expect(ReadNrrdOf("long long int", OneVoxel<long long>(100)));
  expect(ReadNrrdOf("float", OneVoxel<float>(100)));
  expect(ReadNrrdOf("double", OneVoxel<double>(100)));
}

TEST(Segmentation, FindAcceptsNumberOrNameAndListsSegments)
{
  Segmentation segmentation;
  segmentation.Source = "x.nii";
  segmentation.Segments.resize(2);
  segmentation.Segments[0].Label = 3;
  segmentation.Segments[1].Label = 7;
  segmentation.Segments[1].Name = "gland";
  EXPECT_EQ(segmentation.Find("3").Label, 3);
  EXPECT_EQ(segmentation.Find("7").Label, 7);
  EXPECT_EQ(segmentation.Find("gland").Label, 7);
  segmentation.Segments[0].Name = "7";
  EXPECT_EQ(segmentation.Find("7").Label, 7);
  segmentation.Segments[0].Name = "";
  EXPECT_EQ(MessageOf([&] { segmentation.Find("9"); }),
            "x.nii has no label 9; choose one of those it has: 3, 7 gland.");
  EXPECT_TRUE(Contains(MessageOf([&] { segmentation.Find(""); }), "has no label"));
}

TEST(Segmentation, ReadsSlicerNamesAndColors)
{
  std::string voxels(120, '\0');
  voxels[5] = 2;
  voxels[6] = 5;
  const Segmentation segmentation = ReadSlicer(
      SlicerLines(1, {"Segment0_Name:=Prostat\xc3\xa4", "Segment0_LabelValue:=5",
                      "Segment0_Layer:=0", "Segment0_Color:=0.25 0.5 1", "Segment1_Name:=lost",
                      "Segment1_LabelValue:=9", "Segment1_Layer:=0"}),
      voxels);
  ASSERT_EQ(segmentation.Segments.size(), 2u);
  EXPECT_EQ(segmentation.Segments[0].Label, 2);
  EXPECT_EQ(segmentation.Segments[0].Name, "");
  EXPECT_EQ(segmentation.Segments[1].Label, 5);
  EXPECT_EQ(segmentation.Segments[1].Name, "Prostat\xc3\xa4");
  EXPECT_EQ(segmentation.Segments[1].Color, (std::array<double, 3>{0.25, 0.5, 1.0}));
  ASSERT_EQ(segmentation.Notes.size(), 1u);
  EXPECT_EQ(segmentation.Notes[0], "Segment 9 'lost' is empty and was left out.");
}

TEST(Segmentation, NumbersRepeatedSlicerValuesByOrder)
{
  // Interleaved: layer 0 and layer 1 of each voxel.
  std::string voxels(240, '\0');
  voxels[2 * 10] = 1;
  voxels[2 * 10 + 1] = 1;
  voxels[2 * 11 + 1] = 2;
  const Segmentation segmentation = ReadSlicer(
      SlicerLines(2, {"Segment0_Name:=a", "Segment0_LabelValue:=1", "Segment0_Layer:=0",
                      "Segment1_Name:=b", "Segment1_LabelValue:=1", "Segment1_Layer:=1",
                      "Segment2_Name:=c", "Segment2_LabelValue:=2", "Segment2_Layer:=1"}),
      voxels);
  ASSERT_EQ(segmentation.Layers.size(), 2u);
  ASSERT_EQ(segmentation.Segments.size(), 3u);
  const Segment& b = segmentation.Find("b");
  EXPECT_EQ(b.Label, 2);
  EXPECT_EQ(b.Value, 1);
  EXPECT_EQ(b.Layer, 1);
  EXPECT_EQ(segmentation.Find("3").Name, "c");
  EXPECT_EQ(ValueOf(segmentation, 0, 10), 1);
  EXPECT_EQ(ValueOf(segmentation, 1, 10), 1);
  EXPECT_EQ(ValueOf(segmentation, 0, 11), 0);
  EXPECT_EQ(ValueOf(segmentation, 1, 11), 2);
  EXPECT_EQ(GridOf(segmentation.Layers[1]).Size, (std::array<int, 3>{4, 5, 6}));
}

TEST(Segmentation, OldSlicerFilesHaveOneLayerPerSegment)
{
  std::string voxels(240, '\0');
  voxels[2 * 10] = 1;
  voxels[2 * 11 + 1] = 1;
  const Segmentation segmentation =
      ReadSlicer(SlicerLines(2, {"Segment0_Name:=a", "Segment1_Name:=b"}), voxels);
  ASSERT_EQ(segmentation.Segments.size(), 2u);
  EXPECT_EQ(segmentation.Find("a").Layer, 0);
  EXPECT_EQ(segmentation.Find("b").Layer, 1);
  EXPECT_EQ(segmentation.Find("2").Name, "b");
}

TEST(Segmentation, LeftHandedSlicerLayersKeepPositions)
{
  std::vector<std::string> lines =
      SlicerLines(2, {"Segment0_Name:=a", "Segment0_LabelValue:=1", "Segment0_Layer:=0",
                      "Segment1_Name:=b", "Segment1_LabelValue:=1", "Segment1_Layer:=1"});
  lines[4] = "space directions: none (2,0,0) (0,2,0) (0,0,-2)";
  std::string voxels(240, '\0');
  voxels[0] = 1;
  voxels[2 * 119 + 1] = 1;
  EXPECT_THROW(ReadSlicer(lines, voxels, LeftHandedAxes::Refuse), InputError);
  const Segmentation segmentation = ReadSlicer(lines, voxels);
  // The slices are reversed: voxel 0 of slice 0 is now in slice 5, the last one in slice 0.
  EXPECT_EQ(ValueOf(segmentation, 0, 100), 1);
  EXPECT_EQ(ValueOf(segmentation, 1, 19), 1);
  EXPECT_EQ(GridOf(segmentation.Layers[0]).OriginWorld, Vector3(10, 20, 20));
}

TEST(Segmentation, UsesNamesFileNextToLabelMap)
{
  const TemporaryFolder folder;
  std::string voxels(120, '\0');
  voxels[0] = 1;
  voxels[1] = 2;
  WriteAll(folder / "a.nii.gz", Gzipped(NiftiBytes({}, voxels)));
  WriteAll(folder / "a.nii.txt", "1 Precentral_L 2001\n2 Precentral_R 2002\n\n");
  std::string palette(768, '\0');
  palette[2] = '\xff';
  palette[256 + 2] = '\x33';
  WriteAll(folder / "a.nii.lut", palette);
  const Segmentation segmentation = ReadSegmentation(folder / "a.nii.gz");
  EXPECT_EQ(segmentation.Find("Precentral_L").Label, 1);
  EXPECT_EQ(segmentation.Segments[1].Color, (std::array<double, 3>{1.0, 0.2, 0.0}));
  WriteAll(folder / "a.nii.txt", "some remarks about the case\n");
  const Segmentation unnamed = ReadSegmentation(folder / "a.nii.gz");
  EXPECT_EQ(unnamed.Segments[0].Name, "");
  EXPECT_TRUE(Contains(unnamed.Notes.back(), "is not a list of label names"));
}

TEST(Segmentation, AtlasHasNamesAndVoxelCounts)
{
  const std::filesystem::path path = "/usr/share/mricron/templates/aal.nii.gz";
  PALPATE_REQUIRE_FILE(path);
  const Segmentation segmentation = ReadSegmentation(path);
  ASSERT_EQ(segmentation.Segments.size(), 116u);
  std::ifstream names("/usr/share/mricron/templates/aal.nii.txt");
  for (const Segment& segment : segmentation.Segments)
  {
    int label = 0;
    std::string name;
    std::string code;
    names >> label >> name >> code;
    EXPECT_EQ(segment.Label, label);
    EXPECT_EQ(segment.Name, name);
  }
}

TEST(Segmentation, ReadsEveryRealMask)
{
  const auto folder = DataPath("prostate/picai");
  PALPATE_REQUIRE_FILE(folder);
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    const Segmentation segmentation = ReadSegmentation(entry.path());
    EXPECT_GE(segmentation.Segments.size(), 1u) << entry.path();
    EXPECT_GT(GridOf(segmentation.Layers[0]).Direction.determinant(), 0.999) << entry.path();
  }
}
} // namespace
} // namespace palpate::segmentation_test
