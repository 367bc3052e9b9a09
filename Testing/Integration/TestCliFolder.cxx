// A folder of masks: structures of one patient, or cases.
#include "CohortTable.h"
#include "CommandRun.h"
#include "ImageWriter.h"
#include "JsonLines.h"
#include "LabelImages.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::cli_folder_test
{
namespace
{
using namespace palpate::test;

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

class CliFolder : public testing::Test
{
protected:
  CliFolder() { std::filesystem::create_directory(this->Folder / "masks"); }
  // A sphere of 7 mm around a place of the first axis.
  void WriteSphere(const std::string& name, double middle) const
  {
    LabelGrid grid;
    grid.Size = {{64, 20, 20}};
    WriteImage(this->Folder / ("masks/" + name + ".nii.gz"),
               MakeLabelImage(grid, [&](double x, double y, double z)
                              { return std::hypot(x - middle, y - 9.5, z - 9.5) < 7.0; }));
  }
  void WriteOrgans() const
  {
    WriteSphere("liver", 10.0);
    WriteSphere("spleen", 30.0);
    WriteSphere("kidney_left", 50.0);
  }
  CommandRun Fit(std::vector<std::string> more = {}) const
  {
    more.insert(more.begin(), {"fit", "masks", "--degree", "4"});
    return RunPalpate(more, this->Folder.Path());
  }

  TemporaryFolder Folder;
};

TEST_F(CliFolder, StructuresOfOnePatientAreOneSegmentation)
{
  WriteOrgans();
  const CommandRun run = this->Fit({"--output", "out"});
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(Has(run.Errors, "3 masks on one grid that hardly overlap, taken as structures of one "
                              "patient (--as cases"))
      << run.Errors;
  EXPECT_TRUE(Has(run.Output, "label 1 (kidney_left)")) << run.Output;
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "out/masks_2_liver/model.json"));
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "out/report.html"));
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "out/cohort.csv"));
  EXPECT_TRUE(Has(this->Fit({"--label", "spleen"}).Output, "label 3 (spleen)"));
}

TEST_F(CliFolder, FitsTheSameAsOneFileOfAll)
{
  WriteOrgans();
  EXPECT_EQ(RunPalpate({"convert", "masks", "all.seg.nrrd"}, this->Folder.Path()).Code, 0);
  const auto folder = Lines(this->Fit({"--json"}).Output);
  const auto file = Lines(
      RunPalpate({"fit", "all.seg.nrrd", "--degree", "4", "--json"}, this->Folder.Path()).Output);
  ASSERT_EQ(folder.size(), 3U);
  for (std::size_t n = 0; n < 3; ++n)
  {
    EXPECT_EQ(folder[n]["name"], file[n]["name"]);
    EXPECT_EQ(folder[n]["model"], file[n]["model"]);
    EXPECT_EQ(folder[n]["quality"], file[n]["quality"]);
  }
}

TEST_F(CliFolder, StructuresFittedAtATimeComeInOrderAndAreTheSame)
{
  for (int n = 0; n < 8; ++n)
  {
    WriteSphere("organ" + std::to_string(n), 7.5 * n); // cut off, or overlapping a little
  }
  auto one = Lines(this->Fit({"--as", "structures", "--json", "--jobs", "1"}).Output);
  auto many = Lines(this->Fit({"--as", "structures", "--json", "--jobs", "5"}).Output);
  ASSERT_EQ(one.size(), 8U);
  ASSERT_EQ(many.size(), 8U);
  for (std::size_t n = 0; n < 8; ++n)
  {
    for (const char* key : {"seconds", "peak_memory_mb"})
    {
      one[n].erase(key);
      many[n].erase(key);
    }
    EXPECT_EQ(one[n], many[n]);
  }
}

TEST_F(CliFolder, MasksBetweenAreRefusedWithBothWaysNamed)
{
  WriteSphere("1_left", 10.0);
  WriteSphere("1_right", 50.0);
  WriteSphere("2_left", 11.0);
  WriteSphere("2_right", 51.0);
  const CommandRun run = this->Fit({"--output", "out"});
  EXPECT_EQ(run.Code, 2);
  EXPECT_TRUE(Has(run.Errors, "--as structures") && Has(run.Errors, "--as cases")) << run.Errors;
  EXPECT_EQ(this->Fit({"--as", "structures"}).Code, 0);
  EXPECT_EQ(this->Fit({"--as", "cases", "--output", "out"}).Code, 0);
  EXPECT_EQ(CohortTable::Read(this->Folder / "out/cohort.csv").Rows().size(), 4U);
}

TEST_F(CliFolder, MasksThatMostlyOverlapAreCases)
{
  WriteSphere("a", 10.0);
  WriteSphere("b", 12.0);
  const CommandRun run = this->Fit({"--output", "out"});
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(Has(run.Errors, "taken as cases (--as structures")) << run.Errors;
  EXPECT_EQ(CohortTable::Read(this->Folder / "out/cohort.csv").Rows()[1].Case, "b");
}

// Whatever the masks look like by now.
TEST_F(CliFolder, TableOfCasesIsContinuedAsCases)
{
  WriteOrgans();
  EXPECT_EQ(this->Fit({"--as", "cases", "--output", "out"}).Code, 0);
  const CommandRun again = this->Fit({"--output", "out"});
  EXPECT_EQ(again.Code, 0);
  EXPECT_TRUE(Has(again.Errors, "3 of 3 cases were done before")) << again.Errors;
}

TEST_F(CliFolder, BrokenMasksLeaveTheOthers)
{
  WriteOrgans();
  WriteAll(this->Folder / "masks/broken.nii.gz", "no image");
  const CommandRun run = this->Fit();
  EXPECT_EQ(run.Code, 1);
  EXPECT_TRUE(Has(run.Errors, "masks/broken.nii.gz")) << run.Errors;
  EXPECT_TRUE(Has(run.Errors, "1 of 4 cases were not fitted")) << run.Errors;
  EXPECT_TRUE(Has(run.Output, "(spleen)"));
}

TEST_F(CliFolder, InfoIsOneTableOfStructures)
{
  WriteOrgans();
  const CommandRun run = RunPalpate({"info", "masks"}, this->Folder.Path());
  EXPECT_EQ(run.Code, 0);
  EXPECT_TRUE(Has(run.Output, "folder of masks (3 masks on one grid that hardly overlap)"))
      << run.Output;
  EXPECT_TRUE(Has(run.Output, "kidney_left"));
  WriteAll(this->Folder / "masks/broken.nii.gz", "no image");
  const CommandRun broken = RunPalpate({"info", "masks", "--json"}, this->Folder.Path());
  EXPECT_EQ(broken.Code, 1);
  EXPECT_EQ(Lines(broken.Output).size(), 2U) << "the broken one, and the others";
}

TEST_F(CliFolder, FolderWithoutAReadableMaskStopsNoOtherInput)
{
  WriteAll(this->Folder / "masks/broken.nii.gz", "no image");
  std::filesystem::rename(this->Folder / "masks", this->Folder / "bad");
  std::filesystem::create_directory(this->Folder / "masks");
  WriteSphere("a", 10.0);
  const CommandRun run = RunPalpate({"info", "bad", "masks/a.nii.gz"}, this->Folder.Path());
  EXPECT_EQ(run.Code, 1);
  EXPECT_TRUE(Has(run.Errors, "bad/broken.nii.gz")) << run.Errors;
  EXPECT_TRUE(Has(run.Output, "masks/a.nii.gz")) << run.Output;
}

TEST_F(CliFolder, InfoOfCasesIsThatOfEachFile)
{
  WriteSphere("a", 10.0);
  WriteSphere("b", 12.0);
  const CommandRun run = RunPalpate({"info", "masks"}, this->Folder.Path());
  EXPECT_TRUE(Has(run.Output, "masks/a.nii.gz") && Has(run.Output, "masks/b.nii.gz"));
}
} // namespace
} // namespace palpate::cli_folder_test
