#include "CohortTable.h"
#include "CsvRecords.h"
#include "StartedCommand.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <fstream>
#include <gtest/gtest.h>
#include <memory>

namespace palpate::cli_cohort_test
{
namespace
{
using namespace palpate::test;
using Outcome = palpate::FitResult::Outcome;

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// The fields below a head of numbers.
std::vector<std::string> FieldsOf(const palpate::CsvRecord& row, std::size_t count)
{
  std::vector<std::string> fields;
  for (std::size_t column = 0; column < count; ++column)
  {
    fields.push_back(*row.Find(std::to_string(column)));
  }
  return fields;
}

std::vector<CohortRow> RowsIn(const std::filesystem::path& folder)
{
  return CohortTable::Read(folder / "cohort.csv").Rows();
}

const std::vector<std::string> FitMasks{"fit",      "masks", "--label",  "1",
                                        "--degree", "4",     "--output", "out"};

/// Three masks, one of which is invalid.
class CliCohort : public testing::Test
{
protected:
  CliCohort()
  {
    std::filesystem::create_directory(this->Folder / "masks");
    WriteTwoSpheres(this->Folder / "masks/a.nii.gz");
    WriteAll(this->Folder / "masks/b.nii.gz", "no image");
    WriteTwoSpheres(this->Folder / "masks/c.nii.gz");
    WriteAll(this->Folder / "masks/notes.txt", "not looked at");
  }
  CommandRun Fit() const { return RunPalpate(FitMasks, this->Folder.Path()); }
  CommandRun FitWith(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), "fit");
    return RunPalpate(arguments, this->Folder.Path());
  }
  /// Sends the signal as soon as a table exists.
  CommandRun FitUntilFirstRow(int signal) const
  {
    std::vector<std::string> inOrder = FitMasks;
    inOrder.insert(inOrder.end(), {"--jobs", "1"}); // the first row is that of the first mask
    StartedCommand command(PALPATE_PROGRAM, inOrder, this->Folder.Path());
    EXPECT_TRUE(IsSoon([&] { return std::filesystem::exists(this->Folder / "out/cohort.csv"); }));
    command.Send(signal);
    return command.Finish();
  }
  std::filesystem::file_time_type ModelTime(const std::string& name) const
  {
    return std::filesystem::last_write_time(this->Folder.Path() / "out" / name / "1/model.json");
  }

  TemporaryFolder Folder;
};

TEST_F(CliCohort, EveryMaskIsARowDespiteOneFailure)
{
  const CommandRun run = this->Fit();
  EXPECT_EQ(run.Code, 1);
  EXPECT_TRUE(Has(run.Errors, "1 of 3 cases were not fitted")) << run.Errors;
  const auto rows = RowsIn(this->Folder / "out");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].Case, "a");
  EXPECT_EQ(rows[0].Result.State, Outcome::Fitted);
  EXPECT_EQ(rows[0].Result.Structure.Label, 1);
  EXPECT_EQ(rows[0].Degree, 4);
  EXPECT_GT(rows[0].Result.Dice, 0.9);
  EXPECT_EQ(rows[1].Result.State, Outcome::BadInput);
  EXPECT_TRUE(Has(rows[1].Result.Message, "b.nii.gz")) << rows[1].Result.Message;
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "out" / rows[2].Model));
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "out/report.html"));
}

TEST_F(CliCohort, SecondRunProcessesOnlyChanges)
{
  this->Fit();
  const std::string table = ReadAll(this->Folder / "out/cohort.csv");
  const auto before = this->ModelTime("a");
  const CommandRun again = this->Fit();
  EXPECT_EQ(again.Code, 1);
  EXPECT_TRUE(Has(again.Errors, "3 of 3 cases were done before")) << again.Errors;
  EXPECT_EQ(again.Output, "");
  EXPECT_EQ(ReadAll(this->Folder / "out/cohort.csv"), table);
  // The invalid mask becomes valid; a model is lost.
  WriteTwoSpheres(this->Folder / "masks/b.nii.gz");
  std::filesystem::remove(this->Folder / "out/c/1/model.json");
  const CommandRun third = this->Fit();
  EXPECT_EQ(third.Code, 0) << third.Errors;
  EXPECT_TRUE(Has(third.Errors, "1 of 3 cases were done before")) << third.Errors;
  EXPECT_EQ(this->ModelTime("a"), before);
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "out/c/1/model.json"));
}

TEST_F(CliCohort, ChangedSettingsRerunEveryCase)
{
  this->Fit();
  const CommandRun run =
      this->FitWith({"masks", "--label", "1", "--degree", "3", "--output", "out"});
  EXPECT_FALSE(Has(run.Errors, "done before")) << run.Errors;
  EXPECT_EQ(RowsIn(this->Folder / "out")[0].Degree, 3);
}

TEST_F(CliCohort, ResumesAfterKilledRun)
{
  this->FitUntilFirstRow(SIGKILL);
  const auto rows = RowsIn(this->Folder / "out");
  ASSERT_GE(rows.size(), 1U);
  const auto before = this->ModelTime("a");
  const CommandRun run = this->Fit();
  EXPECT_TRUE(Has(run.Errors, "cases were done before")) << run.Errors;
  EXPECT_EQ(RowsIn(this->Folder / "out").size(), 3U);
  EXPECT_EQ(this->ModelTime("a"), before);
}

TEST_F(CliCohort, InterruptedRunLeavesOnlyCompleteRows)
{
  EXPECT_EQ(this->FitUntilFirstRow(SIGINT).Code, 130);
  const auto rows = RowsIn(this->Folder / "out");
  ASSERT_GE(rows.size(), 1U);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(this->Folder / "out"))
  {
    // AtomicFile's temporary names begin with a dot.
    EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
  }
}

TEST_F(CliCohort, ManifestNamesCasesMasksLabelsAndVolumes)
{
  WriteAll(this->Folder / "masks/list.csv",
           "label,case,mask,volume\r\n2,\"Smith, J\",a.nii.gz,\r\n1,second,c.nii.gz,c.nii.gz\r\n"
           "7,third,c.nii.gz,\r\n1,fourth,missing.nii.gz,\r\n");
  const CommandRun run =
      this->FitWith({"--manifest", "masks/list.csv", "--degree", "3", "--output", "out"});
  EXPECT_EQ(run.Code, 1);
  const auto rows = RowsIn(this->Folder / "out");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].Case, "Smith, J");
  EXPECT_EQ(rows[0].Result.Structure.Label, 2);
  EXPECT_EQ(rows[0].Model, "Smith__J/2/model.json");
  EXPECT_EQ(rows[1].Result.State, Outcome::Fitted);
  EXPECT_EQ(rows[2].Result.Structure.Label, 7);
  EXPECT_EQ(rows[2].Result.State, Outcome::BadInput);
  EXPECT_TRUE(Has(rows[3].Result.Message, "missing.nii.gz")) << rows[3].Result.Message;
}

TEST_F(CliCohort, ChosenCaseKeepsOtherRows)
{
  this->Fit();
  auto arguments = FitMasks;
  arguments.insert(arguments.end(), {"--case", "c", "--frequency", "12"});
  const CommandRun run = RunPalpate(arguments, this->Folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(RowsIn(this->Folder / "out").size(), 3U);
}

TEST_F(CliCohort, NumberOfJobsDoesNotChangeResults)
{
  const auto fit = [this](const std::string& jobs)
  {
    return this->FitWith({"masks", "--label", "1", "--degree", "4", "--output", "out" + jobs,
                          "--jobs", jobs, "--json"});
  };
  const CommandRun one = fit("1");
  const CommandRun three = fit("3");
  EXPECT_EQ(three.Code, one.Code);
  // Results in the order of the cases, whichever ends first; times and folders differ.
  std::vector<std::string> inputs;
  for (std::size_t at = 0; (at = three.Output.find("\"input\":\"", at)) != std::string::npos;)
  {
    at += 9;
    inputs.push_back(three.Output.substr(at, three.Output.find('"', at) - at));
  }
  EXPECT_EQ(inputs,
            (std::vector<std::string>{"masks/a.nii.gz", "masks/b.nii.gz", "masks/c.nii.gz"}));
  const auto expected = RowsIn(this->Folder / "out1");
  const auto rows = RowsIn(this->Folder / "out3");
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    EXPECT_EQ(rows[i].Case, expected[i].Case);
    EXPECT_EQ(rows[i].Key, expected[i].Key);
    EXPECT_EQ(rows[i].Result.State, expected[i].Result.State);
    EXPECT_EQ(rows[i].Result.Message, expected[i].Result.Message);
    EXPECT_EQ(rows[i].Result.Dice, expected[i].Result.Dice);
    EXPECT_EQ(rows[i].Result.ModelToMask.Mean, expected[i].Result.ModelToMask.Mean);
  }
  for (const std::string file : {"a/1/model.json", "a/1/model.vtp", "c/1/surface.vtp"})
  {
    EXPECT_EQ(ReadAll(this->Folder / "out3" / file), ReadAll(this->Folder / "out1" / file)) << file;
  }
}

// One case per cluster job.
TEST_F(CliCohort, SingleCaseRunsKeepEachOthersRows)
{
  std::string list = "case,mask,label\n";
  std::vector<std::string> names;
  for (int i = 0; i < 6; ++i)
  {
    names.push_back("p" + std::to_string(i));
    list += names.back() + ",a.nii.gz,1\n";
  }
  WriteAll(this->Folder / "masks/list.csv", list);
  std::vector<std::unique_ptr<StartedCommand>> jobs;
  for (const std::string& name : names)
  {
    const std::vector<std::string> words{"fit",      "--manifest", "masks/list.csv", "--case", name,
                                         "--degree", "3",          "--output",       "out"};
    jobs.push_back(std::make_unique<StartedCommand>(PALPATE_PROGRAM, words, this->Folder.Path()));
  }
  for (const auto& job : jobs)
  {
    const CommandRun run = job->Finish();
    EXPECT_EQ(run.Code, 0) << run.Errors;
  }
  std::vector<std::string> found;
  for (const CohortRow& row : RowsIn(this->Folder / "out"))
  {
    found.push_back(row.Case);
  }
  EXPECT_EQ(found, names);
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "out/.palpate-cohort.lock"));
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "out/.palpate-cohort-runs.lock"));
}

TEST_F(CliCohort, ConcurrentRunsKeepEachOthersRows)
{
  std::filesystem::create_directory(this->Folder / "others");
  WriteTwoSpheres(this->Folder / "others/x.nii.gz");
  StartedCommand slow(PALPATE_PROGRAM, FitMasks, this->Folder.Path());
  const auto hasLock = [this]
  { return std::filesystem::exists(this->Folder / "out/.palpate-cohort.lock"); };
  EXPECT_TRUE(IsSoon([&] { return std::filesystem::exists(this->Folder / "out/cohort.csv"); }));
  // Between two cases, not while it holds the table's lock.
  EXPECT_TRUE(IsSoon(
      [&]
      {
        slow.Send(SIGSTOP);
        EXPECT_TRUE(IsSoon([&] { return slow.IsStopped(); }));
        if (hasLock())
        {
          slow.Send(SIGCONT);
          return false;
        }
        return true;
      }));
  const CommandRun other =
      this->FitWith({"others", "--label", "1", "--degree", "4", "--output", "out"});
  EXPECT_EQ(other.Code, 0) << other.Errors;
  slow.Send(SIGCONT);
  EXPECT_EQ(slow.Finish().Code, 1);
  EXPECT_EQ(RowsIn(this->Folder / "out").size(), 4U);
}

TEST_F(CliCohort, UnlistedCaseIsRemovedFromTable)
{
  this->Fit();
  std::filesystem::remove(this->Folder / "masks/b.nii.gz");
  this->Fit();
  EXPECT_EQ(RowsIn(this->Folder / "out").size(), 2U);
}

TEST_F(CliCohort, EveryStructureIsARowWithoutLabels)
{
  const CommandRun run =
      this->FitWith({"masks", "--case", "a", "--degree", "3", "--output", "out"});
  EXPECT_EQ(run.Code, 0) << run.Errors;
  const auto rows = RowsIn(this->Folder / "out");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].Result.Structure.Label, 2);
}

TEST_F(CliCohort, BadInputGivesOneMessage)
{
  std::filesystem::create_directory(this->Folder / "empty");
  WriteAll(this->Folder / "none.csv", "case,mask\n");
  WriteAll(this->Folder / "twice.csv", "case,mask\na,x.nii\nA,y.nii\n");
  WriteAll(this->Folder / "up.csv", "case,mask\n..,x.nii\n");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"masks"}, "--output"},
      {{"empty", "--output", "out"}, "empty has no readable segmentation or surface"},
      {{"--manifest", "none.csv", "--output", "out"}, "lists no case"},
      {{"--manifest", "twice.csv", "--output", "out"}, "case A"},
      {{"--manifest", "up.csv", "--output", "out"}, "case .."},
      {{"--manifest", "missing.csv", "--output", "out"}, "missing.csv"},
      {{"masks", "--case", "x", "--output", "out"}, "--case x"},
      {{"masks", "--volume", "masks/a.nii.gz", "--output", "out"}, "--volume"},
      {{"masks/a.nii.gz", "--case", "a"}, "--case"}};
  for (const auto& [arguments, part] : cases)
  {
    const CommandRun run = this->FitWith(arguments);
    EXPECT_EQ(run.Code, 2) << part;
    EXPECT_TRUE(Has(run.Errors, part)) << run.Errors;
    EXPECT_EQ(std::count(run.Errors.begin(), run.Errors.end(), '\n'), 1) << run.Errors;
    EXPECT_FALSE(std::filesystem::exists(this->Folder / "out"));
  }
}

TEST(CsvText, RoundTripsAnyField)
{
  const std::vector<std::string> fields{"a,b", "say \"yes\"", "two\nlines", "", " blank ", "é"};
  const std::string line = palpate::CsvLine(fields);
  const auto rows = CsvRecordsIn("0,1,2,3,4,5,6\n" + line + line);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(FieldsOf(rows[0], fields.size()), fields);
  EXPECT_EQ(FieldsOf(rows[1], fields.size()), fields);
  EXPECT_EQ(*rows[0].Find("6"), "") << "one field more";
  const auto marked = CsvRecordsIn("\xEF\xBB\xBFx,y\r\n\r\n1,2");
  ASSERT_EQ(marked.size(), 1U);
  EXPECT_EQ(*marked[0].Find("x"), "1");
  EXPECT_EQ(*marked[0].Find("y"), "2");
}

TEST(CsvText, DisarmsFormulasForSemicolonSeparatorsToo)
{
  const std::vector<std::string> fields{"=1+1", "-1.5", "@a", "a;=1", "'=x", "+x,y"};
  const std::string line = palpate::CsvLine(fields);
  EXPECT_EQ(line, "'=1+1,-1.5,'@a,\"a;=1\",''=x,\"'+x,y\"\n");
  const auto rows = CsvRecordsIn("0,1,2,3,4,5\n" + line);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(FieldsOf(rows[0], fields.size()), fields);
}

TEST_F(CliCohort, FormulaLikeNamesAreDisarmedAndRestored)
{
  WriteAll(this->Folder / "masks/list.csv", "case,mask,label\n=1+1,a.nii.gz,1\n@SUM,c.nii.gz,1\n");
  const CommandRun run =
      this->FitWith({"--manifest", "masks/list.csv", "--degree", "3", "--output", "out"});
  EXPECT_EQ(run.Code, 0) << run.Errors;
  const auto rows = RowsIn(this->Folder / "out");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].Case, "=1+1");
  EXPECT_EQ(rows[1].Case, "@SUM");
  const std::string table = ReadAll(this->Folder / "out/cohort.csv");
  EXPECT_TRUE(Has(table, "\n'=1+1,")) << table;
  EXPECT_TRUE(Has(table, "\n'@SUM,")) << table;
}

TEST_F(CliCohort, MaskNamedLikeParentFolderWritesInsideOutput)
{
  std::filesystem::create_directories(this->Folder / "h/in");
  WriteTwoSpheres(this->Folder / "h/in/...nii.gz");
  WriteTwoSpheres(this->Folder / "h/in/cohort.csv.nii.gz");
  const CommandRun run =
      this->FitWith({"h/in", "--label", "1", "--degree", "3", "--output", "h/out"});
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "h/1"));
  const auto rows = RowsIn(this->Folder / "h/out");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].Model, "__/1/model.json");
  EXPECT_EQ(rows[1].Model, "cohort_csv/1/model.json");
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "h/out/__/1/model.json"));
}

TEST_F(CliCohort, LongNamesWithEqualStartHaveSeparateFolders)
{
  const std::string stem(60, 'x');
  std::filesystem::create_directory(this->Folder / "long");
  WriteTwoSpheres(this->Folder / ("long/" + stem + "1.nii.gz"));
  WriteTwoSpheres(this->Folder / ("long/" + stem + "2.nii.gz"));
  const CommandRun run =
      this->FitWith({"long", "--label", "1", "--degree", "3", "--output", "out"});
  EXPECT_EQ(run.Code, 0) << run.Errors;
  const auto rows = RowsIn(this->Folder / "out");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_NE(rows[0].Model, rows[1].Model);
}

TEST_F(CliCohort, UnwritableCaseKeepsEarlierResult)
{
  const std::vector<std::string> words{"masks", "--case", "a", "--label", "1", "--output", "out"};
  auto first = words;
  first.insert(first.end(), {"--degree", "3"});
  ASSERT_EQ(this->FitWith(first).Code, 0);
  const std::string model = ReadAll(this->Folder / "out/a/1/model.json");
  std::filesystem::remove(this->Folder / "out/a/1/report.html");
  std::filesystem::create_directory(this->Folder / "out/a/1/report.html");
  auto second = words;
  second.insert(second.end(), {"--degree", "4"});
  const CommandRun run = this->FitWith(second);
  EXPECT_EQ(run.Code, 1);
  EXPECT_EQ(ReadAll(this->Folder / "out/a/1/model.json"), model);
  EXPECT_EQ(RowsIn(this->Folder / "out")[0].Result.State, Outcome::Failed);
}
/// Ten ellipsoids, wider with age by 0.2 mm a year; height has nothing to do with it.
class CliCovariates : public testing::Test
{
protected:
  CliCovariates()
  {
    std::filesystem::create_directory(this->Folder / "masks");
    std::string table = "patient_id,age,group\n";
    for (int i = 0; i < 10; ++i)
    {
      const int age = 50 + 3 * i;
      WriteEllipsoid(this->Folder / ("masks/p0" + std::to_string(i) + "_scan.nii.gz"),
                     11.0 + 0.2 * (age - 50), 12.0, 12.0 + (i * 7 % 5) * 0.4);
      table += "p0" + std::to_string(i) + "," + std::to_string(age) + "," +
               (i % 2 == 0 ? "a" : "b") + "\n";
    }
    WriteAll(this->Folder / "patients.csv", table);
  }
  CommandRun Cohort(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), {"cohort", "out"});
    return RunPalpate(arguments, this->Folder.Path());
  }
  CommandRun FromMasks(const std::string& formula) const
  {
    return this->Cohort({"--masks", "masks", "--degree", "4", "--covariates", "patients.csv",
                         "--formula", formula, "--permutations", "199"});
  }

  TemporaryFolder Folder;
};

TEST_F(CliCovariates, AreExplainedFromMasksInOneCommand)
{
  const CommandRun run = this->FromMasks("~ age + group");
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(Has(run.Output, "~ age + group, 10 cases, 199 permutations")) << run.Output;
  const std::vector<palpate::CsvRecord> rows =
      CsvRecordsIn(ReadAll(this->Folder / "out/effects.csv"));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(*rows[0].Find("term"), "age");
  EXPECT_LE(std::stod(*rows[0].Find("surface_p")), 0.01);
  // 0.2 mm a year, 9.1 years the standard deviation; voxels of 1 mm.
  EXPECT_NEAR(std::stod(*rows[0].Find("largest_mm")), 1.8, 0.3);
  EXPECT_GT(std::stod(*rows[1].Find("surface_p")), 0.05);
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "out/effects.vtp"));
  EXPECT_TRUE(Has(ReadAll(this->Folder / "out/cohort.html"), "Covariates"));
}

TEST_F(CliCovariates, LeaveNothingOfAnEarlierModelBehind)
{
  this->FromMasks("~ age");
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "out/effects.csv"));
  EXPECT_EQ(this->Cohort({}).Code, 0);
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "out/effects.csv"));
}

TEST_F(CliCovariates, PageNamesCasesOnlyIfAsked)
{
  this->FromMasks("~ age");
  EXPECT_FALSE(Has(ReadAll(this->Folder / "out/cohort.html"), "p03_scan"));
  this->Cohort({"--names"});
  EXPECT_TRUE(Has(ReadAll(this->Folder / "out/cohort.html"), "p03_scan"));
}

TEST_F(CliCovariates, AnonymousOutputNumbersCasesThatWereMatchedByName)
{
  WriteAll(this->Folder / "masks/p99_scan.nii.gz", "no image");
  EXPECT_EQ(this->FromMasks("~ age").Code, 1);
  EXPECT_FALSE(Has(ReadAll(this->Folder / "out/cohort.html"), "p99_scan")) << "omitted: why";
  const CommandRun run =
      this->Cohort({"--anonymous", "--output", "shared", "--covariates", "patients.csv",
                    "--formula", "~ age", "--permutations", "199", "--export", "spharm-pdm"});
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(Has(run.Output, "~ age, 10 cases")) << run.Output;
  EXPECT_FALSE(Has(run.Output, "_scan")) << run.Output;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(this->Folder / "shared"))
  {
    EXPECT_FALSE(Has(entry.path().filename().string(), "_scan")) << entry.path();
    EXPECT_FALSE(entry.is_regular_file() && Has(ReadAll(entry.path()), "_scan")) << entry.path();
  }
  EXPECT_TRUE(Has(ReadAll(this->Folder / "shared/measures.csv"), "\ncase 10,"));
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "shared/cohort.csv")) << "it names masks";
}

TEST_F(CliCovariates, OfRepeatedScansAreTestedByMixedModelsThatNameNobody)
{
  this->FromMasks("~ age");
  std::string table = "case,patient,months\n";
  for (int i = 0; i < 10; ++i)
  {
    table += "p0" + std::to_string(i) + "_scan,q" + std::to_string(i / 2) + "," +
             std::to_string(i % 2 * 6) + "\n";
  }
  WriteAll(this->Folder / "scans.csv", table);
  const CommandRun run = this->Cohort({"--covariates", "scans.csv", "--repeated", "patient",
                                       "--time", "months", "--anonymous", "--output", "shared"});
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(Has(run.Output, "~ months, random intercept of each patient; 10 cases of 5 patients"))
      << run.Output;
  EXPECT_TRUE(Has(run.Errors + run.Output, "the times are too few")) << run.Errors;
  const std::vector<palpate::CsvRecord> rows =
      CsvRecordsIn(ReadAll(this->Folder / "shared/repeated.csv"));
  ASSERT_GT(rows.size(), 6U);
  EXPECT_EQ(*rows[0].Find("figure"), "volume_ml");
  EXPECT_EQ(*rows[0].Find("degrees"), *rows[0].Find("term_df2"));
  const std::string page = ReadAll(this->Folder / "shared/cohort.html");
  EXPECT_TRUE(Has(page, "Repeated scans"));
  EXPECT_FALSE(Has(page, "_scan"));
}

TEST_F(CliCovariates, SidesAreComparedInPairsAndInTheMidline)
{
  this->FromMasks("~ age");
  CommandRun run = this->Cohort({"--asymmetry", "midline", "--permutations", "199"});
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(Has(run.Output, "asymmetry of 10 shapes against their mirror images")) << run.Output;
  EXPECT_TRUE(Has(ReadAll(this->Folder / "out/cohort.html"), "Asymmetry"));
  std::string table = "case,patient,side\n";
  for (int i = 0; i < 10; ++i)
  {
    table += "p0" + std::to_string(i) + "_scan,q" + std::to_string(i / 2) +
             (i % 2 == 0 ? ",left\n" : ",right\n");
  }
  WriteAll(this->Folder / "sides.csv", table);
  run = this->Cohort(
      {"--asymmetry", "patient,side", "--covariates", "sides.csv", "--permutations", "199"});
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(Has(run.Output, "asymmetry of 5 pairs")) << run.Output;
  EXPECT_EQ(CsvRecordsIn(ReadAll(this->Folder / "out/asymmetry.csv")).size(), 5U);
  EXPECT_EQ(this->Cohort({"--asymmetry", "patient,side"}).Code, 2);
  EXPECT_EQ(this->Cohort({"--asymmetry", "middle"}).Code, 2);
}

TEST_F(CliCovariates, AreRefusedInOneSentence)
{
  this->FromMasks("~ age");
  const CommandRun run = this->Cohort({"--covariates", "patients.csv", "--formula", "~ weight"});
  EXPECT_EQ(run.Code, 2);
  EXPECT_TRUE(Has(run.Errors, "no column weight; they have patient_id, age, group")) << run.Errors;
  EXPECT_EQ(this->Cohort({"--covariates", "patients.csv"}).Code, 2);
}

TEST_F(CliCovariates, CasesAreWrittenForOtherTools)
{
  this->FromMasks("~ age");
  EXPECT_EQ(this->Cohort({"--export", "spharm-pdm", "--export", "shapeworks"}).Code, 0);
  EXPECT_TRUE(std::filesystem::exists(
      this->Folder /
      "out/spharm-pdm/Step3_ParaToSPHARMMesh/p09_scan_pp_surf_SPHARM_procalign.vtk"));
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "out/shapeworks/cohort.swproj"));
}
} // namespace
} // namespace palpate::cli_cohort_test
