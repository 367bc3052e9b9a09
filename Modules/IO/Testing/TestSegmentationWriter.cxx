#include "FileSizeLimit.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "LabelImages.h"
#include "SegmentationFile.h"
#include "SegmentationWriter.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::segmentation_writer_test
{
namespace
{
// A layer of random labels up to `most` on one oblique, anisotropic grid.
vtkSmartPointer<vtkImageData> Layer(int type, int most, std::uint64_t seed)
{
  std::mt19937_64 turn(3);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(13, 7, 5);
  image->SetSpacing(0.3125, 0.5, 3.6);
  image->SetOrigin(-81.25, 17.5, 240.125);
  image->SetDirectionMatrix(test::RandomRotation(turn).data());
  image->AllocateScalars(type, 1);
  std::mt19937_64 random(seed);
  vtkDataArray* voxels = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < voxels->GetNumberOfTuples(); ++i)
  {
    voxels->SetTuple1(i, static_cast<double>(random() % static_cast<std::uint64_t>(most + 1)));
  }
  return image;
}

Segment Named(int value, int layer, const std::string& name, double red)
{
  Segment segment;
  segment.Value = segment.Label = value;
  segment.Layer = layer;
  segment.Name = name;
  segment.Color = {red, 0.25, 1.0 / 3.0};
  return segment;
}

class SegmentationWriterTest : public testing::Test
{
protected:
  Segmentation WrittenAndRead(const Segmentation& segmentation)
  {
    WriteSegmentation(this->File, segmentation);
    return ReadSegmentation(this->File);
  }
  static void ExpectSameLayers(const Segmentation& read, const Segmentation& written)
  {
    ASSERT_EQ(read.Layers.size(), written.Layers.size());
    for (std::size_t layer = 0; layer < read.Layers.size(); ++layer)
    {
      vtkImageData* a = read.Layers[layer];
      vtkImageData* b = written.Layers[layer];
      double place[3];
      double other[3];
      a->TransformIndexToPhysicalPoint(12, 6, 4, place);
      b->TransformIndexToPhysicalPoint(12, 6, 4, other);
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_NEAR(place[axis], other[axis], 1e-10); // rounding of the direction's normalisation
      }
      vtkDataArray* values = a->GetPointData()->GetScalars();
      vtkDataArray* expected = b->GetPointData()->GetScalars();
      ASSERT_EQ(values->GetNumberOfTuples(), expected->GetNumberOfTuples());
      for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
      {
        ASSERT_EQ(values->GetTuple1(i), expected->GetTuple1(i)) << layer << ", " << i;
      }
    }
  }

  const test::TemporaryFolder Folder;
  const std::filesystem::path File = this->Folder / "a.seg.nrrd";
};

TEST_F(SegmentationWriterTest, KeepsLabelsNamesColoursAndGrid)
{
  Segmentation written;
  written.Layers = {Layer(VTK_UNSIGNED_SHORT, 3, 1)};
  written.Layers[0]->GetPointData()->GetScalars()->SetTuple1(5, 700.0);
  written.Segments = {Named(1, 0, "Drüse, links", 0.125), Named(2, 0, "", 0.5),
                      Named(3, 0, "two\nlines", 1.0), Named(700, 0, "one voxel", 0.0)};
  const Segmentation read = this->WrittenAndRead(written);
  ExpectSameLayers(read, written);
  ASSERT_EQ(read.Segments.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(read.Segments[i].Label, written.Segments[i].Label);
    EXPECT_EQ(read.Segments[i].Color, written.Segments[i].Color);
  }
  EXPECT_EQ(read.Segments[0].Name, "Drüse, links");
  EXPECT_EQ(read.Segments[1].Name, "Segment_2");
  EXPECT_EQ(read.Segments[2].Name, "two lines");
  EXPECT_TRUE(read.Notes.empty());
  EXPECT_TRUE(read.IsOriented);
}

TEST_F(SegmentationWriterTest, KeepsOverlappingLayersOfDifferentTypes)
{
  Segmentation written;
  written.Layers = {Layer(VTK_UNSIGNED_CHAR, 2, 1), Layer(VTK_INT, 1, 2),
                    Layer(VTK_UNSIGNED_CHAR, 1, 3)};
  written.Layers[1]->GetPointData()->GetScalars()->SetTuple1(7, 100000.0);
  written.Segments = {Named(1, 0, "a", 0.1), Named(2, 0, "b", 0.2), Named(1, 1, "c", 0.3),
                      Named(100000, 1, "d", 0.4), Named(1, 2, "e", 0.5)};
  const Segmentation read = this->WrittenAndRead(written);
  ExpectSameLayers(read, written);
  ASSERT_EQ(read.Segments.size(), 5U);
  EXPECT_EQ(read.Find("d").Value, 100000);
  EXPECT_EQ(read.Find("e").Layer, 2);
}

// Slicer reads segments only within their extents.
TEST_F(SegmentationWriterTest, ExtentIsTheBoxOfTheSegment)
{
  Segmentation written;
  written.Layers = {Layer(VTK_UNSIGNED_CHAR, 0, 1)};
  written.Segments = {Named(4, 0, "box", 0.1)};
  for (int k = 1; k <= 3; ++k)
  {
    written.Layers[0]->SetScalarComponentFromDouble(2 + k, 6, k, 0, 4.0);
  }
  WriteSegmentation(this->File, written);
  const std::string text = ReadWholeFile(this->File, 1 << 20);
  EXPECT_NE(text.find("\nSegment0_Extent:=3 5 6 6 1 3\n"), std::string::npos) << text;
}

TEST_F(SegmentationWriterTest, ImageUnderSuchANameBecomesSegments)
{
  WriteImage(this->File, Layer(VTK_SHORT, 2, 4));
  const Segmentation read = ReadSegmentation(this->File);
  ASSERT_EQ(read.Segments.size(), 2U);
  EXPECT_EQ(read.Segments[1].Name, "Segment_2");
}

TEST_F(SegmentationWriterTest, ImageOfOtherThanLabelsIsRefused)
{
  const auto image = Layer(VTK_FLOAT, 3, 5);
  image->GetPointData()->GetScalars()->SetTuple1(0, 0.5);
  EXPECT_THROW(WriteImage(this->File, image), InputError);
  EXPECT_FALSE(std::filesystem::exists(this->File));
}

TEST_F(SegmentationWriterTest, FullDiskIsReportedAndLeavesTheFormerFile)
{
  Segmentation written;
  written.Layers = {Layer(VTK_UNSIGNED_SHORT, 60000, 6)};
  written.Segments = {Named(1, 0, "a", 0.1)};
  WriteWholeFile(this->File, "former");
  {
    const test::FileSizeLimit limit(700);
    EXPECT_THROW(WriteSegmentation(this->File, written), InputError);
  }
  EXPECT_EQ(ReadWholeFile(this->File, 100), "former");
}
} // namespace
} // namespace palpate::segmentation_writer_test
