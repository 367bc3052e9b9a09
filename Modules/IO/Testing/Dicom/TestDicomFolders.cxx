#include "DicomFolders.h"

#include "DicomSeries.h"
#include "MessageOf.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include <gtest/gtest.h>

namespace palpate::dicom_folders_test
{
namespace
{
using namespace palpate::test;

// Two slices of a series in a folder.
void WriteSeries(const std::filesystem::path& folder, int number, const std::string& date = {})
{
  std::filesystem::create_directories(folder);
  for (int i = 0; i < 2; ++i)
  {
    DicomSliceSpec slice;
    slice.SeriesUid = "1.2." + std::to_string(number);
    slice.SeriesNumber = number;
    slice.Description = "series " + std::to_string(number);
    slice.Date = date;
    slice.PositionWorld = {0.0, 0.0, 3.0 * i};
    WriteDicomSlice(folder / (std::to_string(number) + "-" + std::to_string(i) + ".dcm"), slice);
  }
}

TEST(DicomFolders, SeriesOfSubfoldersCanBeRead)
{
  const TemporaryFolder top;
  WriteSeries(top / "b/late", 3, "20260531");
  WriteSeries(top / "a", 1);
  WriteSeries(top / "a", 2);
  std::filesystem::create_directory(top / "empty");
  WriteAll(top / "b/notes.txt", "no slice");
  const auto choices = FindDicomSeriesBelow(top.Path());
  ASSERT_EQ(choices.size(), 3U);
  EXPECT_EQ(choices[0].Text(), "'series 1' 2 slices, axial, in a");
  EXPECT_EQ(choices[1].Series, "2");
  EXPECT_EQ(choices[2].Text(), "'series 3' 2 slices, axial, 2026-05-31, in b/late");
  EXPECT_EQ(choices[2].Series, "");
  for (const DicomSeriesChoice& choice : choices)
  {
    EXPECT_EQ(ReadVolume(choice.Folder, {choice.Series}).Image->GetDimensions()[2], 2);
  }
}

TEST(DicomFolders, OwnSeriesComeFirst)
{
  const TemporaryFolder top;
  WriteSeries(top / "a", 1);
  WriteSeries(top.Path(), 2);
  const auto choices = FindDicomSeriesBelow(top.Path());
  ASSERT_EQ(choices.size(), 2U);
  EXPECT_EQ(choices[0].Folder, top.Path());
  EXPECT_EQ(choices[0].Text(), "'series 2' 2 slices, axial");
}

TEST(DicomFolders, MessageIsThatOfOneFolder)
{
  const TemporaryFolder top;
  std::filesystem::create_directories(top / "a/b");
  EXPECT_EQ(MessageOf([&] { FindDicomSeriesBelow(top.Path()); }),
            MessageOf([&] { FindDicomSeries(top.Path()); }));
}

TEST(DicomFolders, LinksAreNotFollowed)
{
  const TemporaryFolder top;
  WriteSeries(top / "a", 1);
  std::filesystem::create_directory_symlink(top.Path(), top / "a/loop");
  EXPECT_EQ(FindDicomSeriesBelow(top.Path()).size(), 1U);
}

TEST(DicomFolders, OnlyDatesAreShownAsDates)
{
  const TemporaryFolder top;
  WriteSeries(top.Path(), 1, "DOE^JOHN");
  EXPECT_EQ(FindDicomSeries(top.Path()).front().Date, "");
}
} // namespace
} // namespace palpate::dicom_folders_test
