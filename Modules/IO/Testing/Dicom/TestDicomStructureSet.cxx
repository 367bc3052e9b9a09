#include "DicomStructureSet.h"

#include "ImageContent.h"
#include "LabelStatistics.h"
#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SyntheticContours.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include "vtkDataArray.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::dicom_structure_set_test
{
namespace
{
using namespace palpate::test;

Segmentation Read(const StructureSetSpec& spec)
{
  const TemporaryFolder folder;
  WriteStructureSet(folder / "rs.dcm", spec);
  return ReadSegmentation(folder / "rs.dcm");
}

std::string Refusal(const StructureSetSpec& spec)
{
  return MessageOf([&] { Read(spec); });
}

// The box with the coordinates of its second contour replaced.
std::string RefusalOfContour(const std::string& coordinates)
{
  StructureSetSpec spec = BoxOfContours({0, 3, 6});
  spec.Structures[0].Contours[1].Coordinates = coordinates;
  return Refusal(spec);
}

// Next to images of 4 x 3 pixels of 2 x 1.5 mm, slices 3 mm apart.
Segmentation ReadNextToImages(const StructureSetSpec& spec, int slices)
{
  const TemporaryFolder folder;
  for (int i = 0; i < slices; ++i)
  {
    DicomSliceSpec slice;
    slice.PositionWorld = {1, 2, 3.0 * i};
    WriteDicomSlice(folder / ("slice" + std::to_string(i) + ".dcm"), slice);
  }
  WriteStructureSet(folder / "rs.dcm", spec);
  return ReadSegmentation(folder / "rs.dcm");
}

vtkIdType VoxelCount(const Segmentation& segmentation, int label)
{
  for (const Segment& segment : segmentation.Segments)
  {
    if (segment.Label == label)
    {
      vtkDataArray* values = segmentation.Layers[static_cast<std::size_t>(segment.Layer)]
                                 ->GetPointData()
                                 ->GetScalars();
      vtkIdType count = 0;
      for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
      {
        count += values->GetTuple1(i) == segment.Value ? 1 : 0;
      }
      return count;
    }
  }
  return 0;
}

double VolumeOf(const Segmentation& segmentation, int label)
{
  const double* spacing = segmentation.Layers[0]->GetSpacing();
  return static_cast<double>(VoxelCount(segmentation, label)) * spacing[0] * spacing[1] *
         spacing[2];
}

bool HasNote(const Segmentation& segmentation, const std::string& part)
{
  return std::any_of(segmentation.Notes.begin(), segmentation.Notes.end(),
                     [&part](const std::string& note)
                     { return note.find(part) != std::string::npos; });
}

// 10 x 6 mm on four slices of 3 mm.
TEST(DicomStructureSet, BoxHasItsVolume)
{
  const Segmentation box = Read(BoxOfContours({0, 3, 6, 9}));
  ASSERT_EQ(box.Segments.size(), 1u);
  EXPECT_EQ(box.Segments[0].Label, 1);
  EXPECT_EQ(box.Segments[0].Name, "box");
  EXPECT_EQ(VolumeOf(box, 1), 10.0 * 6.0 * 12.0);
  EXPECT_TRUE(HasNote(box, "were not found next to the file"));
  EXPECT_TRUE(HasNote(box, "pixels of 1 mm"));
}

TEST(DicomStructureSet, BoxTouchesNoBorder)
{
  for (const std::vector<double>& heights :
       {std::vector<double>{0, 3, 6}, std::vector<double>{0, 3, 6, 12}})
  {
    const Segmentation box = Read(BoxOfContours(heights));
    EXPECT_FALSE(MeasureLabels(box).at(0).TouchesBorder());
  }
}

TEST(DicomStructureSet, FineContoursGiveFinePixels)
{
  StructureSetSpec spec = BoxOfContours({0, 3});
  for (auto& contour : spec.Structures[0].Contours)
  {
    std::vector<Vector3> circle;
    for (int i = 0; i < 120; ++i)
    {
      const double angle = 2.0 * 3.14159265358979 * i / 120;
      circle.emplace_back(10 * std::cos(angle), 10 * std::sin(angle),
                          &contour == &spec.Structures[0].Contours[0] ? 0.0 : 3.0);
    }
    contour.Coordinates = ContourText(circle);
  }
  const Segmentation disc = Read(spec);
  EXPECT_NEAR(disc.Layers[0]->GetSpacing()[0], 20 * std::sin(3.14159265358979 / 120), 1e-6);
  // Voxels of 0.5 mm in a disc of 314 mm2: the border's 240 voxels are right on the average.
  EXPECT_NEAR(VolumeOf(disc, 1), 6 * 314.0, 20.0);
}

TEST(DicomStructureSet, NestedContoursAndChannelsAreHoles)
{
  StructureSetSpec nested = BoxOfContours({0, 3});
  StructureSetSpec keyhole = BoxOfContours({});
  for (const double z : {0.0, 3.0})
  {
    nested.Structures[0].Contours.push_back({RectangleText(2, 2, 6, 4, z), "CLOSEDPLANAR_XOR"});
    keyhole.Structures[0].Contours.push_back({ContourText({{0, 0, z},
                                                           {10, 0, z},
                                                           {10, 6, z},
                                                           {0, 6, z},
                                                           {0, 2, z},
                                                           {2, 2, z},
                                                           {2, 4, z},
                                                           {6, 4, z},
                                                           {6, 2, z},
                                                           {0, 2, z}})});
  }
  EXPECT_EQ(VolumeOf(Read(nested), 1), 6.0 * (60 - 8));
  EXPECT_EQ(VolumeOf(Read(keyhole), 1), 6.0 * (60 - 8));
}

TEST(DicomStructureSet, OverlappingStructuresAreInLayers)
{
  StructureSetSpec spec = BoxOfContours({0, 3});
  spec.Structures.push_back(spec.Structures[0]);
  spec.Structures[1].Number = 7;
  spec.Structures[1].Name = "other";
  spec.Structures[1].Color = "255\\0\\51";
  const Segmentation both = Read(spec);
  ASSERT_EQ(both.Layers.size(), 2u);
  ASSERT_EQ(both.Segments.size(), 2u);
  EXPECT_EQ(both.Segments[1].Label, 2);
  EXPECT_EQ(both.Segments[1].Name, "other");
  EXPECT_EQ(both.Segments[1].Color, (std::array<double, 3>{1.0, 0.0, 0.2}));
  EXPECT_EQ(VoxelCount(both, 1), VoxelCount(both, 2));
}

TEST(DicomStructureSet, PointsLinesAndEmptyStructuresAreNoted)
{
  StructureSetSpec spec = BoxOfContours({0, 3});
  spec.Structures[0].Contours.push_back({"1\\2\\3", "POINT"});
  spec.Structures[0].Contours.push_back({"1\\2\\3\\4\\5\\6\\7\\8\\9", "OPEN_PLANAR"});
  spec.Structures.push_back({2, "none", {}, ""});
  const Segmentation box = Read(spec);
  EXPECT_EQ(box.Segments.size(), 1u);
  EXPECT_TRUE(HasNote(box, "2 points or open lines were left out"));
  EXPECT_TRUE(HasNote(box, "'none' is empty and was left out"));
}

TEST(DicomStructureSet, VoxelsAreThoseOfImagesNextToFile)
{
  const Segmentation box = ReadNextToImages(BoxOfContours({0, 3, 6}), 4);
  EXPECT_TRUE(HasNote(box, "on the voxels of the images next to the file"));
  vtkImageData* image = box.Layers[0];
  EXPECT_EQ(image->GetSpacing()[0], 2.0);
  EXPECT_EQ(image->GetSpacing()[1], 1.5);
  EXPECT_EQ(image->GetSpacing()[2], 3.0);
  const Vector3 origin(image->GetOrigin());
  const Vector3 offset = (origin - Vector3(1, 2, 0)).cwiseQuotient(Vector3(2, 1.5, 3));
  EXPECT_LT((offset - offset.array().round().matrix()).norm(), 1e-12);
  // Centres at x = 1, 3, ... 9 and y = 0.5, 2, 3.5, 5.
  EXPECT_EQ(VoxelCount(box, 1), 5 * 4 * 3);
}

TEST(DicomStructureSet, ImagesOfOtherSeriesAreNotUsed)
{
  StructureSetSpec spec = BoxOfContours({0, 3, 6});
  spec.SeriesUid = "9.9";
  EXPECT_TRUE(HasNote(ReadNextToImages(spec, 4), "were not found next to the file"));
}

TEST(DicomStructureSet, ContoursOnEverySecondSliceFillTwo)
{
  const Segmentation box = ReadNextToImages(BoxOfContours({0, 6, 12}), 6);
  EXPECT_EQ(VoxelCount(box, 1), 5 * 4 * 6);
  EXPECT_FALSE(MeasureLabels(box).at(0).TouchesBorder());
}

TEST(DicomStructureSet, ContoursFinerThanImagesFillEverySliceOnce)
{
  const Segmentation box = ReadNextToImages(BoxOfContours({0, 1, 2, 3, 4, 5, 6}), 4);
  EXPECT_EQ(VoxelCount(box, 1), 5 * 4 * 3);
}

TEST(DicomStructureSet, NotesContoursThatAreMissing)
{
  EXPECT_TRUE(HasNote(Read(BoxOfContours({0, 3, 9, 12})), "lacks 1 slice"));
  EXPECT_TRUE(HasNote(ReadNextToImages(BoxOfContours({0, 3, 9, 12}), 6), "(S 6 mm)"));
  EXPECT_FALSE(HasNote(Read(BoxOfContours({0, 3, 6, 9})), "lacks"));
}

TEST(DicomStructureSet, ObliqueContoursHaveTheirPlanes)
{
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.4, Vector3::UnitZ()) * Eigen::AngleAxisd(-0.3, Vector3::UnitX()))
          .toRotationMatrix();
  StructureSetSpec spec = BoxOfContours({});
  for (const double z : {0.0, 2.0, 4.0})
  {
    std::vector<Vector3> points;
    for (const Vector3& point :
         {Vector3(0, 0, z), Vector3(20, 0, z), Vector3(20, 20, z), Vector3(0, 20, z)})
    {
      points.emplace_back(turn * point);
    }
    spec.Structures[0].Contours.push_back({ContourText(points)});
  }
  const Segmentation box = Read(spec);
  const Vector3 normal(box.Layers[0]->GetDirectionMatrix()->GetElement(0, 2),
                       box.Layers[0]->GetDirectionMatrix()->GetElement(1, 2),
                       box.Layers[0]->GetDirectionMatrix()->GetElement(2, 2));
  // Coordinates have ten digits.
  EXPECT_LT((normal - turn.col(2)).norm(), 1e-8);
  // Axes along L as far as possible, so its sides are oblique: a perimeter of 80 voxels.
  EXPECT_NEAR(VolumeOf(box, 1), 20.0 * 20.0 * 6.0, 80.0);
}

TEST(DicomStructureSet, IsReadAsSegmentationOnly)
{
  const TemporaryFolder folder;
  WriteStructureSet(folder / "rs", BoxOfContours({0, 3}));
  EXPECT_TRUE(Contains(MessageOf([&] { ReadVolume(folder / "rs"); }),
                       "is a DICOM structure set (contours); read it as a segmentation"));
  EXPECT_EQ(ReadImageContent(folder / "rs").Kind, "DICOM structure set");
  EXPECT_EQ(ReadSegmentation(folder.Path()).Segments.size(), 1u);
}

TEST(DicomStructureSet, RejectsDamagedContours)
{
  EXPECT_TRUE(Contains(RefusalOfContour("0\\0\\3\\x\\0\\3\\1\\1\\3"), "is not a number"));
  EXPECT_TRUE(Contains(RefusalOfContour("0\\0\\3\\nan\\0\\3\\1\\1\\3"), "is not a number"));
  EXPECT_TRUE(Contains(RefusalOfContour("0\\0\\3\\1e999\\0\\3\\1\\1\\3"), "is not a number"));
  EXPECT_TRUE(Contains(RefusalOfContour("0\\0\\3\\1\\0\\3\\1\\1"), "are not triples"));
  EXPECT_TRUE(Contains(RefusalOfContour("0\\0\\3\\1\\0\\3\\1\\1\\4.5"), "not parallel"));
  EXPECT_TRUE(Contains(RefusalOfContour(RectangleText(0, 0, 10, 6, 3.7)), "uneven gaps"));
  EXPECT_TRUE(Contains(RefusalOfContour(RectangleText(0, 0, 9000, 6, 3)), "that extend over"));
  EXPECT_TRUE(Contains(RefusalOfContour(RectangleText(0, 0, 1e200, 6, 3)), "contours"));
  EXPECT_TRUE(Contains(RefusalOfContour(RectangleText(0, 0, 10, 6, 1e9)), "slice"));
}

TEST(DicomStructureSet, RejectsSetsWithoutContours)
{
  EXPECT_TRUE(Contains(Refusal(BoxOfContours({})), "has no closed contours"));
  EXPECT_TRUE(Contains(Refusal(BoxOfContours({0})), "distance between its slices"));
  StructureSetSpec flat = BoxOfContours({});
  flat.Structures[0].Contours = {{"0\\0\\0\\1\\1\\1\\2\\2\\2"}};
  EXPECT_TRUE(Contains(Refusal(flat), "without an area"));
}

// A few bytes that enclose much are filled with larger pixels.
TEST(DicomStructureSet, MemoryIsBoundedByText)
{
  StructureSetSpec spec = BoxOfContours({});
  for (int i = 0; i < 60; ++i)
  {
    spec.Structures[0].Contours.push_back({RectangleText(0, 0, 2000, 2000, i)});
  }
  const Segmentation large = Read(spec);
  EXPECT_LT(large.Layers[0]->GetNumberOfPoints(), 3 << 20);
  EXPECT_NEAR(VolumeOf(large, 1) / (2000.0 * 2000.0 * 60.0), 1.0, 0.02);
}

TEST(DicomStructureSet, TimeIsBoundedByText)
{
  StructureSetSpec spec = BoxOfContours({});
  for (const double z : {0.0, 1.0})
  {
    std::vector<Vector3> points;
    for (int i = 0; i < 50000; ++i)
    {
      points.emplace_back(i % 7, i % 2 == 0 ? 0.001 * i : 2000, z);
    }
    spec.Structures[0].Contours.push_back({ContourText(points)});
  }
  EXPECT_TRUE(Contains(Refusal(spec), "go to and fro too often"));
}

TEST(DicomStructureSet, RejectsFilesTruncatedAnywhere)
{
  const TemporaryFolder folder;
  WriteStructureSet(folder / "rs.dcm", BoxOfContours({0, 3}));
  const std::string bytes = ReadAll(folder / "rs.dcm");
  for (std::size_t length = 0; length < bytes.size(); length += 3)
  {
    WriteAll(folder / "cut.dcm", bytes.substr(0, length));
    const std::string message = MessageOf([&] { ReadSegmentation(folder / "cut.dcm"); });
    EXPECT_EQ(message.find("Secret"), std::string::npos);
    EXPECT_NE(message, "no error") << length;
  }
}
} // namespace
} // namespace palpate::dicom_structure_set_test
