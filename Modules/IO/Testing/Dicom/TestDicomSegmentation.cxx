#include "DicomSegmentation.h"
#include "ImageGrid.h"
#include "LabelStatistics.h"
#include "MessageOf.h"
#include "RandomShapes.h"
#include "SegmentColor.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "TestData.h"

#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::dicom_segmentation_test
{
namespace
{
using namespace palpate::test;

Segmentation ReadBack(const DicomSegmentationSpec& spec)
{
  const TemporaryFolder folder;
  WriteDicomSegmentation(folder / "a.dcm", spec);
  return ReadSegmentation(folder / "a.dcm");
}

std::string Refusal(const DicomSegmentationSpec& spec)
{
  return MessageOf([&] { ReadBack(spec); });
}

// Twelve pixels with these set.
std::vector<int> Pixels(const std::vector<int>& inside, int value = 1)
{
  std::vector<int> pixels(12, 0);
  for (const int pixel : inside)
  {
    pixels[static_cast<std::size_t>(pixel)] = value;
  }
  return pixels;
}

// The label at a pixel of the slice at a height (mm), 0 outside.
int LabelAt(const Segmentation& segmentation, std::size_t layer, double height, int pixel)
{
  vtkImageData* image = segmentation.Layers[layer];
  const Vector3 world(10.0 + 2.0 * (pixel % 4), 20.0 + 2.0 * (pixel / 4), height);
  double index[3];
  image->TransformPhysicalPointToContinuousIndex(world.data(), index);
  return static_cast<int>(image->GetScalarComponentAsDouble(
      static_cast<int>(std::lround(index[0])), static_cast<int>(std::lround(index[1])),
      static_cast<int>(std::lround(index[2])), 0));
}

// Bits set in each block of the pixels at the end of a file (an uncompressed BINARY object).
std::vector<vtkIdType> SetBits(const std::filesystem::path& file, std::size_t blocks,
                               std::size_t blockBytes)
{
  const std::string bytes = ReadAll(file);
  const std::size_t start = bytes.size() - blocks * blockBytes;
  std::vector<vtkIdType> set(blocks, 0);
  for (std::size_t i = start; i < bytes.size(); ++i)
  {
    const std::bitset<8> bits(static_cast<unsigned char>(bytes[i]));
    set[(i - start) / blockBytes] += static_cast<vtkIdType>(bits.count());
  }
  return set;
}

TEST(DicomSegmentation, PlacesFramesByPosition)
{
  DicomSegmentationSpec spec;
  spec.Segments = {{1, "gland"}};
  // Unordered, with an empty slice at 6 mm that has no frame.
  spec.Frames = {{1, 9.0, Pixels({5})}, {1, 0.0, Pixels({0, 11})}, {1, 3.0, Pixels({7})}};
  const Segmentation segmentation = ReadBack(spec);
  const ImageGrid grid = GridOf(segmentation.Layers[0]);
  EXPECT_EQ(grid.Size, (std::array<int, 3>{4, 3, 4}));
  EXPECT_EQ(grid.Spacing, Vector3(2, 2, 3));
  EXPECT_EQ(grid.OriginWorld, Vector3(10, 20, 0));
  EXPECT_EQ(LabelAt(segmentation, 0, 0.0, 0), 1);
  EXPECT_EQ(LabelAt(segmentation, 0, 0.0, 11), 1);
  EXPECT_EQ(LabelAt(segmentation, 0, 3.0, 7), 1);
  EXPECT_EQ(LabelAt(segmentation, 0, 9.0, 5), 1);
  const std::vector<LabelStatistics> statistics = MeasureLabels(segmentation);
  EXPECT_EQ(statistics[0].Voxels, 4);
  EXPECT_EQ(segmentation.Segments[0].Name, "gland");
}

TEST(DicomSegmentation, DerivesUnstatedSpacingFromPositions)
{
  DicomSegmentationSpec spec;
  spec.StatedStep = 0.0;
  spec.Frames = {{1, 0.0, Pixels({0})}, {1, 4.0, Pixels({0})}, {1, 12.0, Pixels({0})}};
  EXPECT_EQ(GridOf(ReadBack(spec).Layers[0]).Spacing[2], 4.0);
  // A stated spacing that contradicts the positions is ignored.
  spec.StatedStep = 3.0;
  EXPECT_EQ(GridOf(ReadBack(spec).Layers[0]).Spacing[2], 4.0);
}

TEST(DicomSegmentation, RestoresRandomFrames)
{
  Random random(31);
  for (int round = 0; round < 50; ++round)
  {
    DicomSegmentationSpec spec;
    // Frames of 12 bits: every other one starts at half a byte.
    for (int slice = 0; slice < 7; ++slice)
    {
      std::vector<int> pixels(12, 0);
      for (int& pixel : pixels)
      {
        pixel = random() % 10 == 0 ? 1 : 0;
      }
      spec.Frames.push_back({1, 3.0 * slice, pixels});
    }
    spec.Frames[3].Pixels[11] = 1;
    const Segmentation segmentation = ReadBack(spec);
    for (const auto& frame : spec.Frames)
    {
      for (int pixel = 0; pixel < 12; ++pixel)
      {
        ASSERT_EQ(LabelAt(segmentation, 0, frame.Height, pixel),
                  frame.Pixels[static_cast<std::size_t>(pixel)])
            << "round " << round << ", height " << frame.Height << ", pixel " << pixel;
      }
    }
  }
}

TEST(DicomSegmentation, OverlappingSegmentsUseFurtherLayers)
{
  DicomSegmentationSpec spec;
  spec.Segments = {{1, "a"}, {2, "b"}, {3, "c"}};
  spec.Frames = {{1, 0.0, Pixels({0, 1})},
                 {2, 0.0, Pixels({1, 2})},
                 {3, 0.0, Pixels({2, 3})},
                 {3, 3.0, Pixels({1})}};
  const Segmentation segmentation = ReadBack(spec);
  ASSERT_EQ(segmentation.Layers.size(), 2u);
  EXPECT_EQ(segmentation.Find("a").Layer, 0);
  EXPECT_EQ(segmentation.Find("b").Layer, 1);
  EXPECT_EQ(segmentation.Find("c").Layer, 0);
  EXPECT_EQ(LabelAt(segmentation, 0, 0.0, 1), 1);
  EXPECT_EQ(LabelAt(segmentation, 1, 0.0, 1), 2);
  EXPECT_EQ(LabelAt(segmentation, 0, 0.0, 2), 3);
  EXPECT_EQ(LabelAt(segmentation, 0, 3.0, 1), 3);
}

TEST(DicomSegmentation, ThresholdsFractionalAtHalfWithNote)
{
  DicomSegmentationSpec spec;
  spec.Kind = "FRACTIONAL";
  spec.BitsAllocated = 8;
  std::vector<int> pixels = Pixels({0}, 49);
  pixels[1] = 50;
  pixels[2] = 100;
  spec.Frames = {{1, 0.0, pixels}, {1, 3.0, Pixels({4}, 100)}};
  const Segmentation segmentation = ReadBack(spec);
  EXPECT_EQ(MeasureLabels(segmentation)[0].Voxels, 3);
  EXPECT_EQ(LabelAt(segmentation, 0, 0.0, 0), 0);
  EXPECT_TRUE(Contains(segmentation.Notes.front(), "half its maximum (100)"));
}

TEST(DicomSegmentation, LabelMapValuesBecomeSegments)
{
  DicomSegmentationSpec spec;
  spec.Kind = "LABELMAP";
  spec.BitsAllocated = 16;
  spec.Segments = {{1, "a"}, {300, "b"}};
  std::vector<int> pixels = Pixels({0, 1}, 1);
  pixels[6] = 300;
  spec.Frames = {{0, 3.0, pixels}, {0, 0.0, Pixels({8}, 300)}};
  const Segmentation segmentation = ReadBack(spec);
  ASSERT_EQ(segmentation.Segments.size(), 2u);
  EXPECT_EQ(segmentation.Find("b").Label, 300);
  EXPECT_EQ(segmentation.Layers[0]->GetScalarType(), VTK_UNSIGNED_SHORT);
  EXPECT_EQ(LabelAt(segmentation, 0, 3.0, 6), 300);
  EXPECT_EQ(LabelAt(segmentation, 0, 0.0, 8), 300);
  EXPECT_EQ(LabelAt(segmentation, 0, 3.0, 1), 1);
}

TEST(DicomSegmentation, NamesUnknownKind)
{
  DicomSegmentationSpec spec;
  spec.Kind = "SPECTRAL";
  spec.Frames = {{1, 0.0, Pixels({0})}, {1, 3.0, Pixels({0})}};
  EXPECT_TRUE(Contains(Refusal(spec), "of the kind 'SPECTRAL', which is not supported"));
}

TEST(DicomSegmentation, RejectsUnevenFrames)
{
  DicomSegmentationSpec spec;
  spec.Frames = {{1, 0.0, Pixels({0})}, {1, 3.0, Pixels({0})}, {1, 7.5, Pixels({0})}};
  EXPECT_TRUE(Contains(Refusal(spec), "uneven gaps"));
}

TEST(DicomSegmentation, RejectsEmptyObject)
{
  DicomSegmentationSpec spec;
  spec.Segments = {{1, "a"}};
  spec.Frames = {{1, 0.0, Pixels({})}, {1, 3.0, Pixels({})}};
  EXPECT_TRUE(Contains(Refusal(spec), "has no labelled voxel"));
  EXPECT_FALSE(Contains(Refusal(spec), "Secret"));
}

TEST(DicomSegmentation, LiverMatchesItsPixelData)
{
  const auto path = DataPath("dicom_seg/liver.dcm");
  PALPATE_REQUIRE_FILE(path);
  const Segmentation segmentation = ReadSegmentation(path);
  ASSERT_EQ(segmentation.Segments.size(), 1u);
  EXPECT_EQ(segmentation.Segments[0].Name, "Liver");
  // 3 frames of 512 x 512 bits are the last 98,304 bytes of the file (dcmdump).
  EXPECT_EQ(MeasureLabels(segmentation)[0].Voxels, SetBits(path, 1, 98304)[0]);
  const ImageGrid grid = GridOf(segmentation.Layers[0]);
  EXPECT_EQ(grid.OriginWorld, Vector3(-235.2, -226.8, -128.69));
  EXPECT_LT((grid.Spacing - Vector3(0.810547, 0.810547, 1)).norm(), 1e-12);
}

TEST(DicomSegmentation, PartialOverlapKeepsEverySegment)
{
  const auto path = DataPath("dicom_seg/partial_overlaps.dcm");
  PALPATE_REQUIRE_FILE(path);
  const Segmentation segmentation = ReadSegmentation(path);
  ASSERT_EQ(segmentation.Segments.size(), 5u);
  const std::vector<LabelStatistics> statistics = MeasureLabels(segmentation);
  // Frames of 32,768 bytes each, of segments 1, 2, 3, 3, 3, 4, 5 (dcmdump).
  const std::vector<vtkIdType> bits = SetBits(path, 7, 32768);
  const std::array<vtkIdType, 5> expected{bits[0], bits[1], bits[2] + bits[3] + bits[4], bits[5],
                                          bits[6]};
  for (std::size_t i = 0; i < 5; ++i)
  {
    EXPECT_EQ(statistics[i].Voxels, expected[i]) << segmentation.Segments[i].Name;
  }
  EXPECT_EQ(segmentation.Find("DARK_BLUE").Label, 5);
}

TEST(DicomSegmentation, SparseLabelMapHasEmptySlice)
{
  const auto path = DataPath("dicom_seg/sparse-labelmap-noppv.dcm");
  PALPATE_REQUIRE_FILE(path);
  const Segmentation segmentation = ReadSegmentation(path);
  const ImageGrid grid = GridOf(segmentation.Layers[0]);
  // Frames at -177.75 and -172.75 mm, 2.5 mm apart as the file states.
  EXPECT_EQ(grid.Size, (std::array<int, 3>{24, 38, 3}));
  EXPECT_EQ(grid.OriginWorld, Vector3(46.464901, 5.0188098, -177.75));
  for (int voxel = 24 * 38; voxel < 2 * 24 * 38; ++voxel)
  {
    ASSERT_EQ(segmentation.Layers[0]->GetPointData()->GetScalars()->GetTuple1(voxel), 0.0);
  }
  EXPECT_EQ(MeasureLabels(segmentation)[0].ComponentVoxels.size(), 2u);
}

TEST(DicomSegmentation, NotesSlicesThatAreMissingWithinStructure)
{
  DicomSegmentationSpec spec;
  spec.Segments = {{1, "gland"}};
  spec.Frames = {{1, 0.0, Pixels({0})}, {1, 3.0, Pixels({0})}, {1, 12.0, Pixels({0})}};
  const Segmentation segmentation = ReadBack(spec);
  EXPECT_EQ(std::count_if(segmentation.Notes.begin(), segmentation.Notes.end(),
                          [](const std::string& note)
                          {
                            return Contains(note, "1 'gland' lacks 2 slices between its first and "
                                                  "its last (S 6 mm to S 9 mm)");
                          }),
            1);
}

TEST(SegmentColor, CieLabWhiteAndBlackAreNeutral)
{
  const auto white = CieLabToRgb({65535, 32896, 32896});
  const auto black = CieLabToRgb({0, 32896, 32896});
  for (std::size_t channel = 0; channel < 3; ++channel)
  {
    // The standard's matrix has four decimals.
    EXPECT_NEAR(white[channel], 1.0, 1e-3);
    EXPECT_NEAR(black[channel], 0.0, 1e-3);
  }
}

TEST(SegmentColor, RestoresSlicerColors)
{
  // 3D Slicer's colours of liver, tissue and artery, as dcmqi encoded them in the test files.
  const std::array<std::array<std::uint16_t, 3>, 3> encoded{
      {{41661, 41167, 40792}, {43803, 26565, 37722}, {37064, 44082, 41620}}};
  const std::array<std::array<double, 3>, 3> picked{
      {{221, 130, 101}, {128, 174, 128}, {216, 101, 79}}};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto color = CieLabToRgb(encoded[i]);
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      // Rounded to whole 255ths.
      EXPECT_NEAR(255.0 * color[channel], picked[i][channel], 0.5);
    }
  }
}
} // namespace
} // namespace palpate::dicom_segmentation_test
