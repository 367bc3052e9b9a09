#include "CommandRun.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

namespace palpate::cli_frame_test
{
namespace
{
using namespace palpate::test;

TEST(CliFrame, VersionIsPrinted)
{
  const TemporaryFolder folder;
  const CommandRun run = RunPalpate({"--version"}, folder.Path());
  EXPECT_EQ(run.Code, 0);
  EXPECT_EQ(run.Output, "palpate " PALPATE_VERSION "\n");
  EXPECT_EQ(run.Errors, "");
}

TEST(CliFrame, HelpListsEveryCommandAndEndsWithExamples)
{
  const TemporaryFolder folder;
  const CommandRun run = RunPalpate({"--help"}, folder.Path());
  EXPECT_EQ(run.Code, 0);
  for (const char* command : {"info", "fit", "mesh", "evaluate", "convert", "phantom", "render",
                              "completion", "Examples:"})
  {
    EXPECT_NE(run.Output.find(command), std::string::npos) << command;
  }
}

TEST(CliFrame, EveryCommandHelpEndsWithExamples)
{
  const TemporaryFolder folder;
  for (const char* command :
       {"info", "fit", "mesh", "evaluate", "convert", "phantom", "render", "completion"})
  {
    const CommandRun run = RunPalpate({command, "--help"}, folder.Path());
    EXPECT_EQ(run.Code, 0) << command;
    EXPECT_GT(run.Output.find("Examples:"), run.Output.find("Options:")) << command;
    EXPECT_NE(run.Output.find(std::string("  palpate ") + command), std::string::npos) << command;
  }
}

TEST(CliFrame, BadCommandLineExitsWithTwoAndOneMessage)
{
  const TemporaryFolder folder;
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{},
                                             {"frobnicate"},
                                             {"--frobnicate"},
                                             {"evaluate"},
                                             {"evaluate", "a", "--frobnicate"},
                                             {"convert", "a"},
                                             {"convert", "a", "b", "c"},
                                             {"convert", "a", "b", "--frequency", "0"},
                                             {"completion", "tcsh"}})
  {
    const CommandRun run = RunPalpate(words, folder.Path());
    EXPECT_EQ(run.Code, 2) << run.Errors;
    EXPECT_EQ(run.Output, "");
    EXPECT_EQ(run.Errors.rfind("palpate: ", 0), 0u) << run.Errors;
    EXPECT_NE(run.Errors.find("--help"), std::string::npos) << run.Errors;
    EXPECT_EQ(run.Errors.find('\n'), run.Errors.size() - 1) << run.Errors;
  }
}

TEST(CliFrame, BadCommandLineNamesHelpCommand)
{
  const TemporaryFolder folder;
  const CommandRun run = RunPalpate({"convert", "a"}, folder.Path());
  EXPECT_NE(run.Errors.find("palpate convert --help"), std::string::npos) << run.Errors;
}

TEST(CliFrame, QuietWorksBeforeAndAfterCommand)
{
  const TemporaryFolder folder;
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"--quiet", "completion", "bash"}, {"completion", "bash", "--quiet"}})
  {
    EXPECT_EQ(RunPalpate(words, folder.Path()).Code, 0);
  }
}

TEST(CliFrame, FullOutputDeviceIsFailure)
{
  const TemporaryFolder folder;
  const CommandRun run =
      RunCommand("sh", {"-c", PALPATE_PROGRAM " completion bash > /dev/full"}, folder.Path());
  EXPECT_EQ(run.Code, 1);
  EXPECT_NE(run.Errors.find("standard output"), std::string::npos) << run.Errors;
}

TEST(CliFrame, BashAcceptsCompletionScript)
{
  const TemporaryFolder folder;
  WriteAll(folder / "c", RunPalpate({"completion", "bash"}, folder.Path()).Output);
  const CommandRun run = RunCommand("bash", {"-n", "c"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
}

// Bash completions of the last word of a command line.
std::string Offered(const TemporaryFolder& folder, const std::string& words)
{
  const std::string script = "source c; COMP_WORDS=(palpate " + words +
                             "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _palpate; "
                             "echo \" ${COMPREPLY[*]} \"";
  return RunCommand("bash", {"-c", script}, folder.Path()).Output;
}

TEST(CliFrame, BashCompletesCommandsOptionsAndValues)
{
  const TemporaryFolder folder;
  WriteAll(folder / "c", RunPalpate({"completion", "bash"}, folder.Path()).Output);
  EXPECT_EQ(Offered(folder, "ev"), " evaluate \n");
  EXPECT_EQ(Offered(folder, "evaluate --fr"), " --frequency \n");
  EXPECT_EQ(Offered(folder, "completion z"), " zsh \n");
  EXPECT_EQ(Offered(folder, "mesh a.nii --method pl"), " plain \n");
  EXPECT_EQ(Offered(folder, "mesh a.nii --qu"), " --quiet \n");
  EXPECT_EQ(Offered(folder, "mesh a.nii --json --meth"), " --method \n");
  EXPECT_EQ(Offered(folder, "mesh a.nii --json --method pl"), " plain \n");
  // No completions after an option that takes a file: bash then offers file names.
  EXPECT_EQ(Offered(folder, "render --output x"), "  \n");
}

TEST(CliFrame, ZshAndFishScriptsNameEveryCommand)
{
  const TemporaryFolder folder;
  for (const char* shell : {"zsh", "fish"})
  {
    const std::string script = RunPalpate({"completion", shell}, folder.Path()).Output;
    for (const char* command : {"info", "fit", "mesh", "evaluate", "convert", "completion"})
    {
      EXPECT_NE(script.find(command), std::string::npos) << shell << " " << command;
    }
    const CommandRun there =
        RunCommand("sh", {"-c", std::string("command -v ") + shell}, folder.Path());
    if (there.Code == 0)
    {
      WriteAll(folder / "c", script);
      const CommandRun run = RunCommand(shell, {"-n", "c"}, folder.Path());
      EXPECT_EQ(run.Code, 0) << shell << ": " << run.Errors;
    }
  }
}
} // namespace
} // namespace palpate::cli_frame_test
