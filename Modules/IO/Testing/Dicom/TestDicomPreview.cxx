#include "DicomPreview.h"

#include "SyntheticImages.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::dicom_preview_test
{
namespace
{
using namespace palpate::test;

class DicomPreviewTest : public testing::Test
{
protected:
  // Three slices in another order than their places; the middle one is a ramp along columns.
  DicomPreviewTest()
  {
    for (const int place : {2, 0, 1})
    {
      DicomSliceSpec slice;
      slice.PositionWorld = {0.0, 0.0, 3.0 * place};
      const int count = slice.Columns * slice.Rows;
      for (int i = 0; i < count; ++i)
      {
        slice.Pixels.push_back(place == 1 ? 100 * (i % slice.Columns) : 7);
      }
      WriteDicomSlice(this->Folder / (std::to_string(place) + ".dcm"), slice);
    }
  }
  const TemporaryFolder Folder;
};

TEST_F(DicomPreviewTest, IsTheMiddleSliceFromBlackToWhite)
{
  const DicomPreview preview = ReadDicomPreview(FindDicomSeries(this->Folder.Path()).front(), 64);
  ASSERT_EQ(preview.Grey.size(), static_cast<std::size_t>(preview.Width * preview.Height));
  EXPECT_EQ(std::max(preview.Width, preview.Height), 64);
  const auto row = static_cast<std::size_t>(preview.Width);
  EXPECT_EQ(preview.Grey.front(), 0);
  EXPECT_EQ(preview.Grey[row - 1], 255);
  EXPECT_TRUE(std::is_sorted(preview.Grey.begin(), preview.Grey.begin() + preview.Width));
}

TEST_F(DicomPreviewTest, UnreadableSliceHasNone)
{
  const std::vector<DicomSeries> all = FindDicomSeries(this->Folder.Path());
  std::filesystem::remove(this->Folder / "1.dcm");
  EXPECT_TRUE(ReadDicomPreview(all.front(), 64).Grey.empty());
}
} // namespace
} // namespace palpate::dicom_preview_test
