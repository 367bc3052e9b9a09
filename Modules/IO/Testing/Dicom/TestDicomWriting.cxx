#include "DicomDataset.h"
#include "DicomSegmentationWriter.h"
#include "DicomSource.h"
#include "DicomStructureSetWriter.h"
#include "DicomSurfaceWriter.h"
#include "DicomWriting.h"
#include "LabelImages.h"
#include "MessageOf.h"
#include "SegmentColor.h"
#include "SegmentationFile.h"
#include "SourceSeries.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include "vtkNew.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <random>

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dctk.h"

namespace palpate::dicom_writing_test
{
namespace
{
using namespace palpate::test;
using Color = std::array<double, 3>;

Eigen::Matrix3d Oblique(std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  const auto rows = RandomRotation(random);
  return Eigen::Map<const Eigen::Matrix3d>(rows.data()).transpose();
}

Segment Structure(int value, int layer, const std::string& name, const Color& color)
{
  Segment segment;
  segment.Label = segment.Value = value;
  segment.Layer = layer;
  segment.Name = name;
  segment.Color = color;
  return segment;
}

// A block with a hole through it as 1, and scattered voxels as 2.
int BlockAndVoxels(int i, int j, int k)
{
  const bool isBlock = i > 0 && i < 7 && j > 0 && j < 6 && k < 4;
  const bool isHole = i == 3 && j > 1 && j < 4;
  return isBlock && !isHole ? 1 : (i * 5 + j * 3 + k * 7) % 11 == 0 ? 2 : 0;
}

class DicomWriting : public testing::Test
{
protected:
  Segmentation Mask(const SourceSeries& series,
                    const Eigen::Matrix3d& order = Eigen::Matrix3d::Identity())
  {
    Segmentation mask;
    mask.Source = "mask";
    mask.Layers = {series.Labels(BlockAndVoxels, order)};
    mask.Segments = {Structure(1, 0, "block", {1.0, 0.5, 0.0}),
                     Structure(2, 0, "", {0.2, 0.3, 0.9})};
    return mask;
  }
  // Whether the voxels of the series have the mask's labels.
  static void ExpectSameVoxels(const Segmentation& read, const SourceSeries& series)
  {
    ASSERT_EQ(read.Layers.size(), 1U);
    for (int k = 0; k < series.Grid.Size[2]; ++k)
    {
      for (int j = 0; j < series.Grid.Size[1]; ++j)
      {
        for (int i = 0; i < series.Grid.Size[0]; ++i)
        {
          ASSERT_EQ(ValueAt(read.Layers[0], series.PositionOf(i, j, k)), BlockAndVoxels(i, j, k))
              << i << " " << j << " " << k;
        }
      }
    }
  }
  // Errors of the standard's checker, which Debian has as dicom3tools.
  std::string Complaints(const std::filesystem::path& file) const
  {
    const std::filesystem::path log = this->Folder / "log";
    const std::string command = "dciodvfy '" + file.string() + "' >'" + log.string() + "' 2>&1";
    std::system(command.c_str()); // NOLINT
    std::istringstream lines(ReadAll(log));
    std::string complaints;
    for (std::string line; std::getline(lines, line);)
    {
      complaints += line.rfind("Error", 0) == 0 ? line + "\n" : "";
    }
    return complaints;
  }

  const TemporaryFolder Folder;
  const std::filesystem::path Images = this->Folder / "series";
  const std::filesystem::path File = this->Images / "a.dcm";
};

TEST_F(DicomWriting, SegmentationKeepsVoxelsInEveryOrientation)
{
  const SourceSeries series(this->Images, Oblique(5));
  const DicomSource source(this->Images);
  for (const Eigen::Matrix3d& order : RightHandedOrders())
  {
    EXPECT_TRUE(WriteDicomSegmentation(this->Folder / "a.dcm", this->Mask(series, order), source));
    const Segmentation read = ReadSegmentation(this->Folder / "a.dcm");
    EXPECT_EQ(read.Layers[0]->GetDimensions()[0], 9) << "not on the series' slices";
    ExpectSameVoxels(read, series);
  }
}

TEST_F(DicomWriting, ContoursKeepVoxelsInEveryOrientation)
{
  const SourceSeries series(this->Images, Oblique(6));
  const DicomSource source(this->Images / "slice2.dcm");
  for (const Eigen::Matrix3d& order : RightHandedOrders())
  {
    EXPECT_TRUE(WriteDicomStructureSet(this->File, this->Mask(series, order), source));
    ExpectSameVoxels(ReadSegmentation(this->File), series);
  }
}

TEST_F(DicomWriting, NamesColoursAndCodesSurvive)
{
  const SourceSeries series(this->Images, Oblique(7));
  Segmentation mask = this->Mask(series);
  SegmentCodes& codes = mask.Segments[0].Codes;
  codes.Category = {"SCT", "123037004", "Anatomical Structure"};
  codes.Type = {"SCT", "64033007", "Kidney"};
  codes.TypeModifier = {"SCT", "7771000", "Left"};
  codes.Region = {"SCT", "818981001", "Abdomen"};
  codes.RegionModifier = {"99X", "123456789012345678", "a long code"};
  mask.Segments[0].Name = "G\u00e4rtner\\" + std::string(80, 'x');
  WriteDicomSegmentation(this->File, mask, DicomSource(this->Images));
  const Segmentation read = ReadSegmentation(this->File);
  ASSERT_EQ(read.Segments.size(), 2U);
  EXPECT_EQ(read.Segments[0].Name, "G\u00e4rtner " + std::string(56, 'x'));
  EXPECT_EQ(read.Segments[1].Name, "label 2");
  for (std::size_t i = 0; i < 2; ++i)
  {
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      // Steps of 255 / 65535 of a*, through a cube near black.
      EXPECT_NEAR(read.Segments[i].Color[channel], mask.Segments[i].Color[channel], 1e-3);
    }
  }
  const SegmentCodes& back = read.Segments[0].Codes;
  EXPECT_EQ(SlicerTagsOf(back), SlicerTagsOf(codes));
  EXPECT_EQ(read.Segments[1].Codes.Type.Value, "85756007") << "Tissue, by default";
}

TEST_F(DicomWriting, OverlappingStructuresStayWhole)
{
  const SourceSeries series(this->Images, Oblique(8));
  Segmentation mask;
  const auto inner = [](int i, int j, int k) { return i > 2 && i < 6 && j > 2 && k > 1 ? 1 : 0; };
  const auto all = [](int, int, int) { return 1; };
  mask.Layers = {series.Labels(all, Eigen::Matrix3d::Identity()),
                 series.Labels(inner, Eigen::Matrix3d::Identity())};
  mask.Segments = {Structure(1, 0, "all", {1, 0, 0}), Structure(1, 1, "inner", {0, 1, 0})};
  mask.Segments[1].Label = 2;
  const DicomSource source(this->Images);
  WriteDicomSegmentation(this->Folder / "a.dcm", mask, source);
  WriteDicomStructureSet(this->File, mask, source);
  for (const auto& file : {this->Folder / "a.dcm", this->File})
  {
    const Segmentation read = ReadSegmentation(file);
    ASSERT_EQ(read.Layers.size(), 2U);
    const Segment& segment = read.Find("inner");
    vtkImageData* layer = read.Layers[static_cast<std::size_t>(segment.Layer)];
    EXPECT_EQ(ValueAt(layer, series.PositionOf(4, 5, 3)), segment.Value);
    EXPECT_EQ(ValueAt(layer, series.PositionOf(2, 5, 3)), 0);
    EXPECT_EQ(ValueAt(read.Layers[static_cast<std::size_t>(read.Find("all").Layer)],
                      series.PositionOf(4, 5, 3)),
              read.Find("all").Value);
  }
}

TEST_F(DicomWriting, FramesAndContoursReferenceTheirSlices)
{
  const SourceSeries series(this->Images, Oblique(9));
  const DicomSource source(this->Images);
  WriteDicomSegmentation(this->File, this->Mask(series), source);
  const DicomDataset object(this->File, DicomDataset::Extent::All);
  const auto frames = DicomItems(object.Root(), DCM_PerFrameFunctionalGroupsSequence);
  ASSERT_EQ(frames.size(), 9U); // the block has four, the voxels five
  for (DcmItem* frame : frames)
  {
    DcmItem* derivation = DicomItem(*frame, DCM_DerivationImageSequence);
    ASSERT_NE(derivation, nullptr);
    DcmItem* image = DicomItem(*derivation, DCM_SourceImageSequence);
    StackedSlice plane;
    ASSERT_TRUE(ReadPlanePosition(*DicomItem(*frame, DCM_PlanePositionSequence), plane));
    const Vector3 along = plane.PositionWorld - series.Grid.OriginWorld;
    const long slice = std::lround(along.norm() / 3.0);
    EXPECT_EQ(DicomText(*image, DCM_ReferencedSOPInstanceUID),
              "1.2.3.4." + std::to_string(slice + 1));
  }
  const auto referenced = DicomItems(object.Root(), DCM_ReferencedSeriesSequence);
  ASSERT_EQ(referenced.size(), 1U);
  EXPECT_EQ(DicomItems(*referenced[0], DCM_ReferencedInstanceSequence).size(), 5U);
}

TEST_F(DicomWriting, OtherGridsKeepTheirOwnPlanes)
{
  const SourceSeries series(this->Images, Oblique(10));
  Segmentation mask = this->Mask(series);
  mask.Layers[0]->SetSpacing(1.1, 0.9, 2.5);
  const DicomSource source(this->Images);
  EXPECT_FALSE(WriteDicomSegmentation(this->Folder / "a.dcm", mask, source));
  const Segmentation read = ReadSegmentation(this->Folder / "a.dcm");
  EXPECT_TRUE(IsSameGrid(GridOf(read.Layers[0]), GridOf(mask.Layers[0])));
  const DicomDataset object(this->Folder / "a.dcm", DicomDataset::Extent::All);
  DcmItem* shared = DicomItem(object.Root(), DCM_SharedFunctionalGroupsSequence);
  EXPECT_EQ(
      DicomItems(*DicomItem(*shared, DCM_DerivationImageSequence), DCM_SourceImageSequence).size(),
      5U);
}

TEST_F(DicomWriting, PartOfTheVoxelsLiesOnTheSeries)
{
  const SourceSeries series(this->Images, Oblique(18));
  SourceSeries part = series;
  part.Grid.Size = {5, 4, 3};
  part.Grid.OriginWorld = series.PositionOf(2, 1, 1);
  Segmentation mask = this->Mask(series);
  mask.Layers[0] = part.Labels([](int i, int, int k) { return i == 4   ? 2
                                                              : k == 2 ? 1
                                                                       : 0; },
                               RightHandedOrders()[7]);
  EXPECT_TRUE(WriteDicomSegmentation(this->Folder / "a.dcm", mask, DicomSource(this->Images)));
  const auto read = ReadSegmentation(this->Folder / "a.dcm").Layers[0];
  EXPECT_EQ(read->GetDimensions()[0], 9);
  EXPECT_EQ(ValueAt(read, series.PositionOf(6, 1, 1)), 2);
  EXPECT_EQ(ValueAt(read, series.PositionOf(5, 4, 3)), 1);
  EXPECT_EQ(ValueAt(read, series.PositionOf(5, 4, 2)), 0);
  EXPECT_EQ(ValueAt(read, series.PositionOf(7, 1, 1)), 0);
}

// Voxels of half the size, so that nearest ones have the same labels.
TEST_F(DicomWriting, ContoursOfFinerVoxelsLieOnSlices)
{
  const SourceSeries series(this->Images, Oblique(15));
  SourceSeries finer = series;
  finer.Grid.Size = {18, 14, 10};
  finer.Grid.Spacing /= 2.0;
  Segmentation mask = this->Mask(series);
  mask.Layers[0] =
      finer.Labels([](int i, int j, int k) { return BlockAndVoxels(i / 2, j / 2, k / 2); },
                   Eigen::Matrix3d::Identity());
  EXPECT_FALSE(WriteDicomStructureSet(this->File, mask, DicomSource(this->Images)));
  ExpectSameVoxels(ReadSegmentation(this->File), series);
}

TEST_F(DicomWriting, StructureBetweenSlicesHasNoContours)
{
  const SourceSeries series(this->Images, Oblique(16));
  SourceSeries finer = series;
  finer.Grid.Size = {9, 7, 10};
  finer.Grid.Spacing[2] = 1.5;
  Segmentation mask = this->Mask(series);
  mask.Layers[0] = finer.Labels([](int, int, int k) { return k == 3   ? 2
                                                             : k == 4 ? 1
                                                                      : 0; },
                                Eigen::Matrix3d::Identity());
  const DicomSource source(this->Images);
  EXPECT_NE(MessageOf([&] { WriteDicomStructureSet(this->File, mask, source); })
                .find("no slice of the series meets the structure 2"),
            std::string::npos);
}

TEST_F(DicomWriting, NamesGiveCodesWithSides)
{
  const SourceSeries series(this->Images, Oblique(17));
  Segmentation mask = this->Mask(series);
  mask.Segments[0].Name = "Kidney_LEFT";
  WriteDicomSegmentation(this->File, mask, DicomSource(this->Images));
  const SegmentCodes codes = ReadSegmentation(this->File).Segments[0].Codes;
  EXPECT_EQ(codes.Category.Value, "123037004");
  EXPECT_EQ(codes.Type.Value, "64033007");
  EXPECT_EQ(codes.TypeModifier.Value, "7771000");
}

TEST_F(DicomWriting, RejectsSeriesElsewhere)
{
  const SourceSeries series(this->Images, Oblique(11));
  Segmentation mask = this->Mask(series);
  const DicomSource source(this->Images);
  for (const double offset : {500.0, -500.0})
  {
    mask.Layers[0]->SetOrigin(offset, offset, offset);
    const std::string message =
        MessageOf([&] { WriteDicomSegmentation(this->File, mask, source); });
    EXPECT_NE(message.find("lies outside of"), std::string::npos) << message;
  }
  EXPECT_FALSE(std::filesystem::exists(this->File));
}

TEST_F(DicomWriting, PatientAndStudyAreThoseOfTheSeries)
{
  const SourceSeries series(this->Images, Oblique(12));
  const DicomSource source(this->Images);
  WriteDicomSegmentation(this->Folder / "seg.dcm", this->Mask(series), source);
  WriteDicomStructureSet(this->Folder / "rs.dcm", this->Mask(series), source);
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  WriteDicomSurface(this->Folder / "stl.dcm", sphere->GetOutput(), source);
  const DicomDataset slice(this->Images / "slice0.dcm", DicomDataset::Extent::UpToPixels);
  std::string instances;
  for (const char* name : {"seg.dcm", "rs.dcm", "stl.dcm"})
  {
    const DicomDataset object(this->Folder / name, DicomDataset::Extent::All);
    for (const DcmTagKey& tag :
         {DCM_PatientName, DCM_PatientID, DCM_StudyInstanceUID, DCM_FrameOfReferenceUID})
    {
      EXPECT_EQ(DicomText(object.Root(), tag), DicomText(slice.Root(), tag));
      EXPECT_NE(DicomText(object.Root(), tag), "");
    }
    EXPECT_EQ(DicomText(object.Root(), DCM_InstitutionName), "") << "of the scanner";
    const std::string instance = DicomText(object.Root(), DCM_SOPInstanceUID);
    EXPECT_EQ(instances.find(instance), std::string::npos);
    instances += instance + " ";
  }
}

TEST_F(DicomWriting, SurfaceIsEmbeddedWithItsLength)
{
  const SourceSeries series(this->Images, Oblique(13));
  const DicomSource source(this->Images);
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  for (const char* name : {"a.dcm", "a.obj.dcm"})
  {
    WriteDicomSurface(this->Folder / name, sphere->GetOutput(), source);
    const DicomDataset object(this->Folder / name, DicomDataset::Extent::All);
    const Uint8* bytes = nullptr;
    Uint32 length = 0;
    ASSERT_TRUE(object.Root().findAndGetUint8Array(DCM_EncapsulatedDocument, bytes).good());
    ASSERT_TRUE(object.Root().findAndGetUint32(DCM_EncapsulatedDocumentLength, length).good());
    const auto surface = this->Folder / (name[2] == 'o' ? "b.obj" : "b.stl");
    WriteWholeFile(surface, {reinterpret_cast<const char*>(bytes), length});
    EXPECT_EQ(ReadSurface(surface)->GetNumberOfCells(), sphere->GetOutput()->GetNumberOfCells());
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(this->Folder.Path()), {}), 5)
      << "files are left";
}

TEST_F(DicomWriting, StandardsCheckerHasNoErrors)
{
  if (std::system("command -v dciodvfy >/dev/null 2>&1") != 0) // NOLINT
  {
    GTEST_SKIP() << "dicom3tools is not installed";
  }
  const SourceSeries series(this->Images, Oblique(14));
  const DicomSource source(this->Images);
  const Segmentation mask = this->Mask(series);
  Segmentation other = this->Mask(series);
  other.Layers[0]->SetSpacing(1.1, 0.9, 2.5);
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  WriteDicomSegmentation(this->Folder / "seg.dcm", mask, source);
  WriteDicomSegmentation(this->Folder / "other.dcm", other, source);
  WriteDicomStructureSet(this->Folder / "rs.dcm", mask, source);
  WriteDicomSurface(this->Folder / "stl.dcm", sphere->GetOutput(), source);
  for (const char* name : {"seg.dcm", "other.dcm", "rs.dcm", "stl.dcm"})
  {
    EXPECT_EQ(this->Complaints(this->Folder / name), "") << name;
  }
}

TEST(DicomDecimals, HaveAtMostSixteenCharacters)
{
  EXPECT_EQ(DicomDecimals({1.0, -0.5, 100.0}), "1\\-0.5\\100");
  for (const double number : {-0.12345678901234567, 1.0 / 3.0, -12345.678901234567, 1e-9, -1e14})
  {
    const std::string text = DicomDecimals({number});
    EXPECT_LE(text.size(), 16U) << text;
    // 14 digits fit beside sign and point.
    EXPECT_NEAR(std::stod(text), number, 5e-14 * std::max(1.0, std::abs(number))) << text;
  }
}
} // namespace
} // namespace palpate::dicom_writing_test
