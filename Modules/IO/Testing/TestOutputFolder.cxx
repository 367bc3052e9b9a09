#include "FileSizeLimit.h"
#include "InputError.h"
#include "OutputFolder.h"
#include "TemporaryFolder.h"
#include "Unprivileged.h"
#include "WholeFile.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace palpate::output_folder_test
{
namespace
{
using palpate::test::FileSizeLimit;
using palpate::test::HoldsUnprivileged;
using palpate::test::ReadAll;
using palpate::test::TemporaryFolder;
using palpate::test::WriteAll;

std::string MessageOf(void (*ask)(const std::filesystem::path&), const std::filesystem::path& path)
{
  try
  {
    ask(path);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return {};
}

// Two files; the second exceeds the limit below.
void WriteSmallAndLarge(const std::filesystem::path& folder)
{
  WriteWholeFile(folder / "a.txt", "new a");
  WriteWholeFile(folder / "b.txt", std::string(4096, 'b'));
}
constexpr rlim_t TooSmall = 1024;

TEST(OutputFolder, CheckCreatesNothing)
{
  const TemporaryFolder folder;
  EXPECT_EQ(MessageOf(CheckOutputFolder, folder / "new/deep"), "");
  EXPECT_EQ(folder.EntryCount(), 0U);
}

TEST(OutputFolder, CreatesParentsAndAcceptsExistingFolder)
{
  const TemporaryFolder folder;
  MakeOutputFolder(folder / "new/deep");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "new/deep"));
  EXPECT_EQ(MessageOf(MakeOutputFolder, folder / "new/deep"), "");
  EXPECT_EQ(MessageOf(CheckOutputFolder, folder / "new/deep"), "");
}

TEST(OutputFolder, NamesFileThatBlocksFolder)
{
  const TemporaryFolder folder;
  WriteAll(folder / "file", "x");
  for (const char* name : {"file", "file/below"})
  {
    for (const auto ask : {CheckOutputFolder, MakeOutputFolder})
    {
      const std::string message = MessageOf(ask, folder / name);
      EXPECT_NE(message.find((folder / name).string()), std::string::npos) << name << message;
    }
  }
}

TEST(OutputFolder, RejectsNamesOfFiles)
{
  const TemporaryFolder folder;
  for (const char* name : {"liver.msh", "a.vtu", "a.3mf", "model.JSON", "a.x3d"})
  {
    const bool isOne = HasFileEnding(folder / name);
    EXPECT_EQ(isOne, std::string(name) != "a.3mf") << name; // starts with a digit, as dates do
    EXPECT_EQ(MessageOf(&CheckOutputFolder, folder / name).find("ending of a file") !=
                  std::string::npos,
              isOne);
  }
  for (const char* name : {"run.2026", "J.Smith", "v1.2", "out", ".hidden", "a.b", "liver.msh/"})
  {
    EXPECT_FALSE(HasFileEnding(folder / name)) << name;
  }
  std::filesystem::create_directory(folder / "there.msh");
  EXPECT_FALSE(HasFileEnding(folder / "there.msh"));
}

TEST(OutputFolder, RejectsReadOnlyFolder)
{
  const TemporaryFolder folder;
  chmod(folder.Path().c_str(), 0555);
  for (const auto ask : {CheckOutputFolder, MakeOutputFolder})
  {
    EXPECT_TRUE(HoldsUnprivileged([&] { return !MessageOf(ask, folder / "new").empty(); }));
  }
  chmod(folder.Path().c_str(), 0700);
}

TEST(OutputFolder, RelativeNamesStartAtWorkingFolder)
{
  EXPECT_EQ(MessageOf(CheckOutputFolder, "no-such-folder-yet"), "");
}

TEST(OutputSet, ReplacesOnlyFilesOfSameName)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.txt", "old a");
  WriteAll(folder / "c.txt", "old c");
  WriteAll(folder / "mine.txt", "mine");
  WriteOutputSet(folder.Path(), WriteSmallAndLarge, {"a.txt", "c.txt", "never.txt"});
  EXPECT_EQ(ReadAll(folder / "a.txt"), "new a");
  EXPECT_EQ(ReadAll(folder / "b.txt").size(), 4096U);
  EXPECT_EQ(ReadAll(folder / "mine.txt"), "mine");
  EXPECT_EQ(folder.EntryCount(), 3U) << "c.txt is obsolete, and nothing temporary is left";
}

TEST(OutputSet, FailureKeepsEarlierResult)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.txt", "old a");
  WriteAll(folder / "c.txt", "old c");
  {
    const FileSizeLimit full(TooSmall);
    EXPECT_THROW(WriteOutputSet(folder.Path(), WriteSmallAndLarge, {"c.txt"}), InputError);
  }
  EXPECT_EQ(ReadAll(folder / "a.txt"), "old a");
  EXPECT_EQ(ReadAll(folder / "c.txt"), "old c");
  EXPECT_EQ(folder.EntryCount(), 2U);
}

TEST(OutputSet, FailureRemovesNewFolder)
{
  const TemporaryFolder folder;
  const FileSizeLimit full(TooSmall);
  EXPECT_THROW(WriteOutputSet(folder / "new/deep", WriteSmallAndLarge), InputError);
  EXPECT_EQ(folder.EntryCount(), 0U);
}

TEST(OutputSet, OneIrreplaceableFileKeepsAllUnchanged)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.txt", "old a");
  std::filesystem::create_directory(folder / "b.txt");
  EXPECT_THROW(WriteOutputSet(folder.Path(), WriteSmallAndLarge), InputError);
  EXPECT_EQ(ReadAll(folder / "a.txt"), "old a");
  EXPECT_EQ(folder.EntryCount(), 2U);
}

TEST(OutputSet, MessagesNameRequestedFile)
{
  const TemporaryFolder folder;
  const FileSizeLimit full(TooSmall);
  try
  {
    WriteOutputSet(folder / "out", WriteSmallAndLarge);
    FAIL();
  }
  catch (const InputError& error)
  {
    EXPECT_EQ(std::string(error.what()).find((folder / "out/b.txt").string() + " cannot"), 0U)
        << error.what();
  }
}

TEST(OutputSet, ReplacesSymbolicLinkAndNotItsTarget)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "elsewhere");
  WriteAll(folder / "elsewhere/target", "old");
  std::filesystem::create_directory(folder / "out");
  std::filesystem::create_symlink("../elsewhere/target", folder / "out/a.txt");
  WriteOutputSet(folder / "out", WriteSmallAndLarge);
  EXPECT_FALSE(std::filesystem::is_symlink(folder / "out/a.txt"));
  EXPECT_EQ(ReadAll(folder / "out/a.txt"), "new a");
  EXPECT_EQ(ReadAll(folder / "elsewhere/target"), "old");
}
} // namespace
} // namespace palpate::output_folder_test
