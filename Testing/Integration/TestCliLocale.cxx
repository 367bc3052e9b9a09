#include "CommaLocale.h"
#include "CommandRun.h"
#include "FractionalImages.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sstream>

namespace palpate::cli_locale_test
{
namespace
{
using namespace palpate::test;

using Words = std::vector<std::string>;

// The cells of a cohort's table except durations and folders.
std::string ComparableCells(const std::string& table)
{
  std::string cells;
  std::istringstream lines(table);
  std::set<std::size_t> others;
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string cell;
    for (std::size_t column = 0; std::getline(words, cell, ','); ++column)
    {
      if (cell == "seconds" || cell == "key")
      {
        others.insert(column);
      }
      cells += others.count(column) > 0 ? "," : cell + ',';
    }
  }
  return cells;
}

// All files of a folder by their names relative to it.
std::map<std::string, std::string> FilesOf(const std::filesystem::path& folder)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
  {
    // A report contains durations.
    if (entry.is_regular_file() && entry.path().filename() != "report.html")
    {
      files[entry.path().lexically_relative(folder).string()] = ReadAll(entry.path());
    }
  }
  return files;
}

// Output and files of a command, in a folder with images, a mask and a manifest of it.
std::map<std::string, std::string> ResultsOf(const Words& words)
{
  const TemporaryFolder folder;
  WriteFractionalImages(folder.Path());
  WriteTwoSpheres(folder / "balls.nrrd");
  WriteAll(folder / "cases.csv", "case,mask,label\nfirst,balls.nrrd,1\n");
  const CommandRun run = RunPalpate(words, folder.Path());
  EXPECT_EQ(run.Code, 0) << words[0] << ": " << run.Errors;
  std::map<std::string, std::string> results = FilesOf(folder.Path());
  if (results.count("o/cohort.csv") > 0)
  {
    results["o/cohort.csv"] = ComparableCells(results["o/cohort.csv"]);
  }
  results["standard output"] = run.Output;
  results["standard error"] = run.Errors;
  return results;
}

TEST(CliLocale, OutputIsIndependentOfDecimalComma)
{
  const Words fit{"--degree", "4", "--frequency", "8", "--smoothing", "0.5"};
  std::vector<Words> commands{{"fit", "balls.nrrd", "--label", "1", "--output", "o"},
                              {"fit", "--manifest", "cases.csv", "--output", "o"}};
  for (Words& command : commands)
  {
    command.insert(command.end(), fit.begin(), fit.end());
  }
  for (const char* file : {"a.nii", "a.seg.nrrd", "a.mha", "dicom", "seg.dcm"})
  {
    commands.push_back({"info", file, "--json"});
  }
  commands.push_back({"convert", "a.nii", "converted.mha"});
  commands.push_back({"convert", "a.mha", "converted.nrrd"});
  commands.push_back({"mesh", "balls.nrrd", "--label", "1", "--output", "mesh.obj"});
  for (const Words& command : commands)
  {
    const auto expected = ResultsOf(command);
    const CommaEnvironment comma;
    const auto results = ResultsOf(command);
    EXPECT_EQ(results.size(), expected.size());
    for (const auto& [name, bytes] : expected)
    {
      const auto found = results.find(name);
      ASSERT_NE(found, results.end()) << name;
      EXPECT_TRUE(found->second == bytes) << command[0] << ' ' << command[1] << ": " << name;
    }
  }
}
} // namespace
} // namespace palpate::cli_locale_test
