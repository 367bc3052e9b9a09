#include "MaskFolderFit.h"

#include "CohortGroup.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "LabelImages.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::mask_folder_fit_test
{
namespace
{
class MaskFolderFitTest : public testing::Test
{
protected:
  void SetUp() override
  {
    std::filesystem::create_directory(this->Masks);
    for (int n = 0; n < 3; ++n)
    {
      this->WriteBall("ball" + std::to_string(n) + ".nii.gz", 8.0 + n);
    }
    this->Settings.Degree = 4;
    this->Settings.Frequency = 8;
  }
  void WriteBall(const std::string& name, double radius)
  {
    test::LabelGrid grid;
    grid.CenterOnOrigin();
    WriteImage(this->Masks / name, test::MakeLabelImage(grid, [radius](double x, double y, double z)
                                                        { return std::hypot(x, y, z) < radius; }));
  }
  CohortTable Fit(const ProgressFunction& progress = {})
  {
    return FitMaskFolder(this->Masks, this->Output, this->Settings, "test", progress);
  }

  test::TemporaryFolder Folder;
  std::filesystem::path Masks = Folder / "masks";
  std::filesystem::path Output = Folder / "models";
  FitSettings Settings;
};

TEST_F(MaskFolderFitTest, MakesACohortThatOpens)
{
  this->Fit();
  const CohortTable table = CohortTable::Read(this->Output / "cohort.csv");
  const CohortGroup group = MakeCohortGroup(table, this->Output, "", AlignmentAxes::Patient);
  ASSERT_EQ(group.Rows.size(), 3U);
  EXPECT_EQ(group.Rows[0].Case, "ball0");
  for (std::size_t n = 0; n < 3; ++n)
  {
    const double radius = 8.0 + static_cast<double>(n);
    const double milliliters = 4.0 / 3.0 * M_PI * std::pow(radius, 3) / 1000.0;
    EXPECT_NEAR(group.Rows[n].Result.ModelMilliliters, milliliters, 0.02 * milliliters);
  }
}

TEST_F(MaskFolderFitTest, MaskThatCannotBeReadIsARowWithTheReason)
{
  WriteWholeFile(this->Masks / "aaa.nii.gz", "no image"); // the first one
  const CohortTable table = this->Fit();
  ASSERT_EQ(table.Rows().size(), 4U);
  EXPECT_TRUE(table.Rows()[0].Model.empty());
  EXPECT_NE(table.Rows()[0].Result.Message.find("aaa.nii.gz"), std::string::npos);
  EXPECT_FALSE(table.Rows()[1].Model.empty());
}

TEST_F(MaskFolderFitTest, CountsMasksAndCanBeCancelled)
{
  std::string last;
  EXPECT_THROW(this->Fit(
                   [&last](double fraction, const std::string& stage)
                   {
                     last = stage;
                     return fraction < 0.5;
                   }),
               Cancelled);
  EXPECT_EQ(last.rfind("2 of 3: ", 0), 0U) << last;
  EXPECT_FALSE(std::filesystem::exists(this->Output / "cohort.csv"));
}

TEST_F(MaskFolderFitTest, RejectsFolderWithoutMasks)
{
  std::filesystem::create_directory(this->Folder / "empty");
  this->Masks = this->Folder / "empty";
  EXPECT_THROW(this->Fit(), InputError);
}
} // namespace
} // namespace palpate::mask_folder_fit_test
