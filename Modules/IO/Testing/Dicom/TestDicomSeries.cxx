#include "DicomSeries.h"
#include "ImageGrid.h"
#include "MessageOf.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "TestData.h"
#include "VolumeFile.h"

#include <gtest/gtest.h>

namespace palpate::dicom_series_test
{
namespace
{
using namespace palpate::test;

// Slices at these heights along their normal, in files whose names do not reveal the order.
void WriteStack(const TemporaryFolder& folder, const std::vector<double>& heights,
                DicomSliceSpec spec = {})
{
  const Vector3 normal = spec.RowWorld.cross(spec.ColumnWorld);
  const Vector3 start = spec.PositionWorld;
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    spec.PositionWorld = start + heights[i] * normal;
    spec.Value = static_cast<std::uint16_t>(10.0 * heights[i]);
    const auto name = "f" + std::to_string(i) + '-' + std::to_string(spec.SeriesNumber) + ".dcm";
    WriteDicomSlice(folder / name, spec);
  }
}

std::string Refusal(const std::filesystem::path& path, const std::string& series = {})
{
  return MessageOf([&] { ReadVolume(path, {series}); });
}

TEST(DicomSeries, OrdersSlicesAlongNormal)
{
  const TemporaryFolder folder;
  DicomSliceSpec spec;
  spec.PositionWorld = {-5, 7, 9};
  spec.RowWorld = {0, 1, 0};
  spec.ColumnWorld = {0, 0, -1};
  WriteStack(folder, {7.5, 0, 5, 2.5}, spec);
  const Volume volume = ReadVolume(folder.Path());
  const ImageGrid grid = GridOf(volume.Image);
  EXPECT_EQ(grid.Size, (std::array<int, 3>{4, 3, 4}));
  // Pixel spacing "1.5\2" is between rows first, so 2 mm along a row.
  EXPECT_LT((grid.Spacing - Vector3(2, 1.5, 2.5)).norm(), 1e-12);
  EXPECT_LT((grid.OriginWorld - Vector3(-5, 7, 9)).norm(), 1e-12);
  EXPECT_LT((grid.Direction.col(2) - Vector3(-1, 0, 0)).norm(), 1e-12);
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(1, 1, k, 0), 25 * k);
  }
}

TEST(DicomSeries, OneFileSelectsItsSeries)
{
  const TemporaryFolder folder;
  WriteStack(folder, {0, 3, 6});
  DicomSliceSpec other;
  other.SeriesUid = "1.2.99";
  other.SeriesNumber = 2;
  WriteStack(folder, {0, 2}, other);
  EXPECT_EQ(GridOf(ReadVolume(folder / "f1-1.dcm").Image).Size[2], 3);
  EXPECT_EQ(GridOf(ReadVolume(folder / "f1-2.dcm").Image).Size[2], 2);
}

TEST(DicomSeries, ListsSeveralSeriesForChoice)
{
  const TemporaryFolder folder;
  WriteStack(folder, {0, 3, 6});
  DicomSliceSpec other;
  other.SeriesUid = "1.2.99";
  other.SeriesNumber = 2;
  other.Description = "the other";
  WriteStack(folder, {0, 2}, other);
  EXPECT_TRUE(Contains(Refusal(folder.Path()),
                       "holds 2 series or orientations (1: 'synthetic' 3 slices, axial, UID 1.2.3, "
                       "2: 'the other' 2 slices, axial, UID 1.2.99)"));
  EXPECT_EQ(GridOf(ReadVolume(folder.Path(), {"2"}).Image).Size[2], 2);
  EXPECT_EQ(GridOf(ReadVolume(folder.Path(), {"1.2.3"}).Image).Size[2], 3);
  EXPECT_TRUE(Contains(Refusal(folder.Path(), "7"), "has no series 7"));
}

TEST(DicomSeries, DoesNotRevealPatientNames)
{
  const TemporaryFolder folder;
  WriteStack(folder, {0, 3, 9});
  EXPECT_FALSE(Contains(Refusal(folder.Path()), "Secret"));
}

TEST(DicomSeries, RejectsMissingSlice)
{
  const TemporaryFolder folder;
  WriteStack(folder, {0, 3, 6, 12, 15});
  EXPECT_TRUE(Contains(Refusal(folder.Path()),
                       "uneven gaps between its slices (3 to 6 mm): about 1 slice missing between "
                       "f2-1.dcm at S 6 mm and f3-1.dcm at S 12 mm"));
}

TEST(DicomSeries, RejectsTwoImagesAtOnePosition)
{
  const TemporaryFolder folder;
  WriteStack(folder, {0, 3});
  DicomSliceSpec echo;
  echo.Value = 77;
  WriteDicomSlice(folder / "echo0.dcm", echo);
  echo.PositionWorld = {0, 0, 3};
  WriteDicomSlice(folder / "echo3.dcm", echo);
  EXPECT_TRUE(Contains(Refusal(folder.Path()),
                       "4 images in 2 positions, such as echo0.dcm and f0-1.dcm at S 0 mm"));
}

TEST(DicomSeries, SliceThatIsThereTwiceIsTakenOnce)
{
  const TemporaryFolder folder;
  WriteStack(folder, {0, 3, 6});
  std::filesystem::copy_file(folder / "f1-1.dcm", folder / "copy of f1.dcm");
  const Volume volume = ReadVolume(folder.Path());
  EXPECT_EQ(GridOf(volume.Image).Size[2], 3);
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(0, 0, 1, 0), 30);
  ASSERT_EQ(volume.Notes.size(), 1u);
  EXPECT_TRUE(Contains(volume.Notes[0], "1 slice is there twice"));
  EXPECT_TRUE(Contains(volume.Notes[0], "at S 3 mm"));
}

TEST(DicomSeries, RejectsTiltedStack)
{
  const TemporaryFolder folder;
  for (int i = 0; i < 4; ++i)
  {
    DicomSliceSpec spec;
    spec.PositionWorld = {0, 0.5 * i, 3.0 * i};
    WriteDicomSlice(folder / (std::to_string(i) + ".dcm"), spec);
  }
  EXPECT_TRUE(Contains(Refusal(folder.Path()), "has sheared axes"));
  VolumeChoice choice;
  choice.Sheared = ShearedAxes::Resample;
  EXPECT_FALSE(IsSheared(GridOf(ReadVolume(folder.Path(), choice).Image)));
}

TEST(DicomSeries, RejectsSlicesShiftedUnevenly)
{
  const TemporaryFolder folder;
  for (int i = 0; i < 6; ++i)
  {
    DicomSliceSpec spec;
    spec.PositionWorld = {0, i == 3 ? 1.0 : 0.0, 3.0 * i};
    WriteDicomSlice(folder / (std::to_string(i) + ".dcm"), spec);
  }
  EXPECT_TRUE(Contains(Refusal(folder.Path()), "shifted sideways"));
}

TEST(DicomSeries, RejectsSingleSlice)
{
  const TemporaryFolder folder;
  WriteStack(folder, {0});
  EXPECT_TRUE(Contains(Refusal(folder.Path()), "is a single slice"));
}

TEST(DicomSeries, RejectsFolderWithoutImages)
{
  const TemporaryFolder folder;
  WriteAll(folder / "notes.txt", "nothing");
  EXPECT_TRUE(Contains(Refusal(folder.Path()), "holds no DICOM file"));
}

TEST(DicomSeries, SkipsOtherFilesInFolder)
{
  const TemporaryFolder folder;
  WriteStack(folder, {0, 3});
  WriteAll(folder / "notes.txt", "nothing");
  EXPECT_EQ(GridOf(ReadVolume(folder.Path()).Image).Size[2], 2);
}

TEST(DicomSeries, AxialSeriesHasGeometryOfHeaders)
{
  const auto path = DataPath("prostate/dicom_t2_axial");
  PALPATE_REQUIRE_FILE(path);
  const ImageGrid grid = GridOf(ReadVolume(path).Image);
  EXPECT_EQ(grid.Size, (std::array<int, 3>{320, 320, 40}));
  // ImagePositionPatient of the lowest slice as dcmdump prints it; slices are 3 mm apart.
  EXPECT_LT((grid.OriginWorld - Vector3(-73.789356708527, -97.73828125, -8.1296310424805)).norm(),
            1e-9);
  // Positions have about 13 decimals; their differences over 39 slices keep ten.
  EXPECT_LT((grid.Spacing - Vector3(0.5, 0.5, 3)).norm(), 1e-9);
  EXPECT_TRUE(grid.Direction.isIdentity(1e-12));
}

TEST(DicomSeries, SeparatesOrientationsOfSameUid)
{
  const auto path = DataPath("prostate/dicom_localizer_three_planes");
  PALPATE_REQUIRE_FILE(path);
  const std::string refusal = Refusal(path);
  EXPECT_TRUE(Contains(refusal, "holds 3 series or orientations"));
  EXPECT_TRUE(Contains(refusal, "1: 'LOCALIZER' 3 slices, sagittal"));
  EXPECT_TRUE(Contains(refusal, "2: 'LOCALIZER' 3 slices, coronal"));
  EXPECT_TRUE(Contains(refusal, "3: 'LOCALIZER' 3 slices, axial"));
  const ImageGrid coronal = GridOf(ReadVolume(path, {"2"}).Image);
  EXPECT_LT((coronal.Direction.col(2) - Vector3(0, 1, 0)).norm(), 1e-12);
  // Positions -7.2, 0, 7.2 in single precision.
  EXPECT_NEAR(coronal.Spacing[2], 7.2, 1e-6);
  const std::string uid = FindDicomSeries(path).front().Uid;
  EXPECT_TRUE(Contains(Refusal(path, uid), "holds 3 series or orientations of UID " + uid));
  EXPECT_EQ(GridOf(ReadVolume(path / "IM0015.dcm").Image).Direction.col(2), Vector3(0, 0, 1));
}
} // namespace
} // namespace palpate::dicom_series_test
