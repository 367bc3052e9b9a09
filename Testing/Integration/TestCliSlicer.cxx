#include "CommandRegistry.h"
#include "CommandRun.h"
#include "DeclaredCommand.h"
#include "TemporaryFolder.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <gtest/gtest.h>
#include <regex>
#include <set>

namespace palpate::cli_slicer_test
{
namespace
{
using namespace palpate::test;
namespace fs = std::filesystem;

std::string ModuleOf(std::string command)
{
  command[0] = static_cast<char>(std::toupper(command[0]));
  return (fs::path(PALPATE_SLICER_FOLDER) / ("Palpate" + command)).string();
}

std::string DescriptionOf(const std::string& command, const TemporaryFolder& folder)
{
  const CommandRun run = RunCommand(ModuleOf(command), {"--xml"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << command << ": " << run.Errors;
  EXPECT_EQ(run.Errors, "");
  return run.Output;
}

// The flags that Slicer passes when no field of the panel was changed.
std::vector<std::string> UnchangedFlags(const std::string& description)
{
  std::vector<std::string> flags;
  const std::regex field(
      "<longflag>([^<]*)</longflag>(?:(?!longflag)[^])*?<default>([^<]+)</default>");
  for (std::sregex_iterator next(description.begin(), description.end(), field), end; next != end;
       ++next)
  {
    if ((*next)[2] != "false")
    {
      flags.insert(flags.end(), {(*next)[1], (*next)[2]});
    }
  }
  return flags;
}

CommandRun RunModule(const std::string& command, const std::vector<std::string>& more,
                     const TemporaryFolder& folder)
{
  std::vector<std::string> words = UnchangedFlags(DescriptionOf(command, folder));
  words.insert(words.end(), more.begin(), more.end());
  return RunCommand(ModuleOf(command), words, folder.Path());
}

// A small body, as a module makes it.
void MakePhantom(const TemporaryFolder& folder)
{
  const CommandRun run = RunModule("phantom", {"--output", "body", "--spacing", "2,2,3"}, folder);
  ASSERT_EQ(run.Code, 0) << run.Errors;
}

std::vector<cli::DeclaredCommand> Declared()
{
  CLI::App app("", "palpate");
  std::vector<cli::DeclaredCommand> commands;
  const auto made = cli::MakeCommands();
  for (const auto& command : made)
  {
    CLI::App* sub = app.add_subcommand(command->Name(), command->Summary());
    command->DeclareOptions(*sub);
    commands.emplace_back(*sub);
  }
  return commands;
}

TEST(CliSlicer, FolderHasModuleForEveryCommandThatWritesFiles)
{
  std::set<std::string> expected;
  for (const cli::DeclaredCommand& command : Declared())
  {
    if (command.IsModule())
    {
      expected.insert(ModuleOf(command.Name));
    }
  }
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(PALPATE_SLICER_FOLDER))
  {
    found.insert(entry.path().string());
  }
  EXPECT_EQ(found, expected);
  EXPECT_GE(found.size(), 8u);
}

TEST(CliSlicer, DescriptionsAreValid)
{
  const TemporaryFolder folder;
  if (RunCommand("sh", {"-c", "command -v xmllint"}, folder.Path()).Code != 0)
  {
    GTEST_SKIP() << "xmllint (Debian's libxml2-utils) is missing";
  }
  for (const cli::DeclaredCommand& command : Declared())
  {
    if (command.IsModule())
    {
      WriteAll(folder / "module.xml", DescriptionOf(command.Name, folder));
      const CommandRun run = RunCommand(
          "xmllint", {"--noout", "--relaxng", PALPATE_SLICER_SCHEMA, "module.xml"}, folder.Path());
      EXPECT_EQ(run.Code, 0) << command.Name << ": " << run.Errors;
    }
  }
}

TEST(CliSlicer, DescriptionHasEveryOptionOnce)
{
  const TemporaryFolder folder;
  for (const cli::DeclaredCommand& command : Declared())
  {
    if (command.IsModule())
    {
      const std::string xml = DescriptionOf(command.Name, folder);
      const auto count = [&xml](const std::string& tag)
      {
        const std::regex pattern(tag);
        return std::distance(std::sregex_iterator(xml.begin(), xml.end(), pattern),
                             std::sregex_iterator());
      };
      // Without --help; --anonymous is the command line's, except that of cohort.
      const long common = command.Name == "cohort" ? 0 : count("<name>anonymous</name>");
      EXPECT_EQ(count("<name>"), static_cast<long>(command.Options.size()) - 1 + common)
          << command.Name;
    }
  }
}

TEST(CliSlicer, FlagsAreBooleansAndRangedNumbersHaveConstraints)
{
  const TemporaryFolder folder;
  const std::string xml = DescriptionOf("fit", folder);
  EXPECT_TRUE(std::regex_search(xml, std::regex("<boolean>\\s*<name>robust<")));
  EXPECT_TRUE(std::regex_search(xml, std::regex("<image type=\"label\">\\s*<name>mask<")));
  EXPECT_TRUE(std::regex_search(xml, std::regex("<integer>\\s*<name>max_degree<")));
  EXPECT_NE(xml.find("<minimum>0</minimum><maximum>100</maximum><step>1</step>"),
            std::string::npos);
}

TEST(CliSlicer, UnchangedPanelsRun)
{
  const TemporaryFolder folder;
  MakePhantom(folder);
  const std::string mask = "body/mask.nii.gz";
  ASSERT_TRUE(fs::exists(folder / mask));
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"fit", "--output", "out", mask},
                                             {"mesh", "--output", "surface.vtp", mask},
                                             {"convert", mask, "mask.nrrd"},
                                             {"touch", "--output", "felt", "surface.vtp"}})
  {
    const CommandRun run = RunModule(words.front(), {words.begin() + 1, words.end()}, folder);
    EXPECT_EQ(run.Code, 0) << words.front() << ": " << run.Errors;
  }
  EXPECT_TRUE(fs::exists(folder / "surface.vtp"));
  EXPECT_TRUE(fs::exists(folder / "mask.nrrd"));
  EXPECT_TRUE(fs::exists(folder / "felt/report.html"));
}

TEST(CliSlicer, ReportsProgressBetweenStartAndEnd)
{
  const TemporaryFolder folder;
  MakePhantom(folder);
  const CommandRun run = RunModule("mesh", {"--output", "surface.vtp", "body/mask.nii.gz"}, folder);
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const std::string& out = run.Output;
  EXPECT_EQ(out.rfind("<filter-start><filter-name>palpate mesh</filter-name></filter-start>", 0),
            0u)
      << out;
  const std::size_t progress = out.find("<filter-progress>");
  const std::size_t end = out.find("<filter-end>");
  EXPECT_LT(progress, end);
  EXPECT_LT(end, out.size());
}

TEST(CliSlicer, UnderscoresAreReadOnlyForSlicer)
{
  const TemporaryFolder folder;
  const CommandRun plain = RunPalpate({"fit", "--max_degree", "2", "missing.nrrd"}, folder.Path());
  EXPECT_NE(plain.Errors.find("--max_degree"), std::string::npos) << plain.Errors;
  const CommandRun slicer = RunPalpate(
      {"--slicer", "fit", "--degree=auto", "--max_degree=2", "miss_ing.nrrd"}, folder.Path());
  EXPECT_NE(slicer.Errors.find("miss_ing.nrrd"), std::string::npos) << slicer.Errors;
}
} // namespace
} // namespace palpate::cli_slicer_test
