#include "CohortTable.h"
#include "CommandRun.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>

namespace palpate::cohort_workflow_test
{
namespace
{
using namespace palpate::test;

using Times = std::map<std::string, std::filesystem::file_time_type>;

/// Four phantoms, one file that is not a mask, one missing file; and Snakemake.
class CohortWorkflow : public testing::Test
{
protected:
  void SetUp() override
  {
    if (RunCommand("snakemake", {"--version"}, this->Folder.Path()).Code != 0)
    {
      GTEST_SKIP() << "snakemake is not installed";
    }
    std::string manifest = "case,mask,label,volume\n";
    for (const char* seed : {"1", "2", "3", "4"})
    {
      const std::string name = std::string("seed ") + seed;
      ASSERT_EQ(RunPalpate({"phantom", "--output", name, "--seed", seed, "--degree", "4",
                            "--spacing", "2,2,3"},
                           this->Folder.Path())
                    .Code,
                0);
      manifest.append(name).append(",").append(name).append("/mask.nii.gz,1,");
      manifest.append(name).append("/volume.nii.gz\n");
    }
    WriteAll(this->Folder / "bad.nii.gz", "no image");
    WriteAll(this->Folder / "manifest.csv",
             manifest + "bad,bad.nii.gz,1,\nmissing,missing.nii.gz,1,\n");
  }
  std::vector<std::string> Arguments(const std::vector<std::string>& more) const
  {
    std::vector<std::string> arguments{"--snakefile", PALPATE_WORKFLOW, "--cores", "1",
                                       "--nocolor"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    for (const std::string& setting :
         {std::string("--config"), std::string("manifest=manifest.csv"), std::string("output=flow"),
          std::string("palpate=") + PALPATE_PROGRAM, std::string("fit=--degree 4")})
    {
      arguments.push_back(setting);
    }
    return arguments;
  }
  CommandRun Snakemake(const std::vector<std::string>& more = {}) const
  {
    return RunCommand("snakemake", this->Arguments(more), this->Folder.Path());
  }
  /// Kills Snakemake and all its jobs as soon as two cases are done: then at least one of them is
  /// recorded as complete.
  void KillAfterTwoCases() const
  {
    std::string command = "setsid snakemake";
    for (const std::string& word : this->Arguments({}))
    {
      command += " '" + word + "'";
    }
    const CommandRun run = RunCommand(
        "sh",
        {"-c", command + " & p=$!; while kill -0 $p; do set -- flow/cases/*/cohort.csv; "
                         "[ $# -ge 2 ] && break; done; kill -s KILL -- -$p; wait $p; exit 0"},
        this->Folder.Path());
    ASSERT_EQ(run.Code, 0);
  }
  Times Tables() const
  {
    Times times;
    for (const auto& entry : std::filesystem::directory_iterator(this->Folder / "flow/cases"))
    {
      if (std::filesystem::exists(entry.path() / "cohort.csv"))
      {
        times[entry.path().filename()] =
            std::filesystem::last_write_time(entry.path() / "cohort.csv");
      }
    }
    return times;
  }

  TemporaryFolder Folder;
};

TEST_F(CohortWorkflow, ResumesAfterKillWithoutRepetition)
{
  this->KillAfterTwoCases();
  const Times before = this->Tables();
  ASSERT_GE(before.size(), 2U);
  ASSERT_LT(before.size(), 6U) << "nothing was left to resume";
  ASSERT_EQ(this->Snakemake({"--unlock"}).Code, 0);
  const CommandRun resumed = this->Snakemake({"--rerun-incomplete"});
  ASSERT_EQ(resumed.Code, 0) << resumed.Errors;
  const Times after = this->Tables();
  EXPECT_EQ(after.size(), 6U);
  const auto kept =
      std::count_if(before.begin(), before.end(),
                    [&](const auto& one) { return after.at(one.first) == one.second; });
  // All but at most the last, which Snakemake may not have recorded as complete.
  EXPECT_GE(kept + 1, static_cast<std::ptrdiff_t>(before.size()));

  const CommandRun again = this->Snakemake();
  EXPECT_EQ(again.Code, 0);
  EXPECT_NE(again.Errors.find("Nothing to be done"), std::string::npos) << again.Errors;

  EXPECT_EQ(RunPalpate({"fit", "--manifest", "manifest.csv", "--degree", "4", "--output", "one"},
                       this->Folder.Path())
                .Code,
            1);
  EXPECT_EQ(RunPalpate({"cohort", "one"}, this->Folder.Path()).Code, 0);
  for (const char* table : {"coefficients.csv", "modes.csv", "variance.csv", "measures.csv"})
  {
    const std::string expected = ReadAll(this->Folder / "one" / table);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(ReadAll(this->Folder / "flow" / table), expected) << table;
  }
  const auto rows = palpate::CohortTable::Read(this->Folder / "flow/cohort.csv").Rows();
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[0].Case, "seed 1");
  EXPECT_EQ(rows[4].Result.State, palpate::FitResult::Outcome::BadInput);
}
} // namespace
} // namespace palpate::cohort_workflow_test
