#include "CommandRun.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iterator>

namespace palpate::cli_outputs_test
{
namespace
{
// What the outputs of commands may replace.

using namespace palpate::test;

constexpr const char* Other =
    "<!DOCTYPE html>\n<html><body>Findings of another program</body></html>\n";

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

class CliOutputs : public testing::Test
{
protected:
  CliOutputs()
  {
    WriteTwoSpheres(this->Folder / "a.nii.gz");
    WriteNearlyASphere(this->Folder / "m.json");
  }
  // Refused with one sentence, and the file is as before.
  void ExpectKept(const std::vector<std::string>& words, const std::string& file,
                  const std::string& reason) const
  {
    const std::string before = ReadAll(this->Folder / file);
    const CommandRun run = RunPalpate(words, this->Folder.Path());
    EXPECT_EQ(run.Code, 2) << words.front() << ": " << run.Errors;
    EXPECT_TRUE(Has(run.Errors, file + " " + reason)) << run.Errors;
    EXPECT_EQ(std::count(run.Errors.begin(), run.Errors.end(), '\n'), 1) << run.Errors;
    EXPECT_EQ(run.Output, "") << words.front();
    EXPECT_EQ(ReadAll(this->Folder / file), before) << words.front();
  }
  void ExpectRefusedInput(const std::vector<std::string>& words, const std::string& file) const
  {
    this->ExpectKept(words, file, "is an input of this command");
  }

  TemporaryFolder Folder;
};

TEST_F(CliOutputs, OwnInputIsNeverReplaced)
{
  std::filesystem::create_symlink("m.json", this->Folder / "link.json");
  std::filesystem::create_directory(this->Folder / "one");
  std::filesystem::copy_file(this->Folder / "m.json", this->Folder / "one/truth.json");
  this->ExpectRefusedInput({"soften", "m.json", "--output", "m.json"}, "m.json");
  this->ExpectRefusedInput({"soften", "m.json", "--output", "link.json"}, "link.json");
  this->ExpectRefusedInput({"soften", "link.json", "--output", "m.json"}, "m.json");
  this->ExpectRefusedInput({"convert", "a.nii.gz", "./a.nii.gz", "--label", "1"}, "a.nii.gz");
  this->ExpectRefusedInput({"phantom", "--model", "one/truth.json", "--output", "one"},
                           "one/truth.json");
}

TEST_F(CliOutputs, ForeignPageInAFolderIsKeptByEveryCommand)
{
  std::filesystem::create_directory(this->Folder / "fo");
  WriteAll(this->Folder / "fo/report.html", Other);
  WriteAll(this->Folder / "fo/tradeoff.html", Other);
  WriteAll(this->Folder / "fo/cohort.html", Other);
  const std::string reason = "would be replaced";
  this->ExpectKept({"fit", "a.nii.gz", "--output", "fo"}, "fo/report.html", reason);
  this->ExpectKept({"touch", "m.json", "--output", "fo"}, "fo/report.html", reason);
  this->ExpectKept({"compare", "m.json", "m.json", "--output", "fo"}, "fo/report.html", reason);
  this->ExpectKept({"tradeoff", "m.json", "--output", "fo"}, "fo/tradeoff.html", reason);
  this->ExpectKept({"cohort", "fo"}, "fo/cohort.html", reason);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(this->Folder / "fo"), {}), 3);
}

TEST_F(CliOutputs, OwnEarlierResultIsReplaced)
{
  const std::vector<std::string> fit{"fit",      "a.nii.gz", "--label",  "1",
                                     "--degree", "2",        "--output", "out"};
  ASSERT_EQ(RunPalpate(fit, this->Folder.Path()).Code, 0);
  WriteAll(this->Folder / "out/model.csv", "a table of no format, beside our page\n");
  const CommandRun again = RunPalpate(fit, this->Folder.Path());
  EXPECT_EQ(again.Code, 0) << again.Errors;
  const std::vector<std::string> touch{"touch", "out/model.json", "--output",
                                       "felt",  "--seconds",      "0.1"};
  ASSERT_EQ(RunPalpate(touch, this->Folder.Path()).Code, 0);
  for (const char* name : {"report.html", "scene.json", "summary.json"})
  {
    std::filesystem::remove(this->Folder / "felt" / name);
  }
  EXPECT_EQ(RunPalpate(touch, this->Folder.Path()).Code, 0) << "session.touch is recognised";
}

TEST_F(CliOutputs, FileThatIsNamedIsReplaced)
{
  WriteAll(this->Folder / "page.html", Other);
  WriteAll(this->Folder / "b.nii.gz", "something");
  EXPECT_EQ(RunPalpate({"convert", "a.nii.gz", "b.nii.gz"}, this->Folder.Path()).Code, 0);
  EXPECT_NE(ReadAll(this->Folder / "b.nii.gz"), "something");
}
} // namespace
} // namespace palpate::cli_outputs_test
