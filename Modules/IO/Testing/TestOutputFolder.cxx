#include "InputError.h"
#include "OutputFolder.h"
#include "TemporaryFolder.h"
#include "Unprivileged.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

using palpate::CheckOutputFolder;
using palpate::InputError;
using palpate::MakeOutputFolder;
using palpate::test::HoldsUnprivileged;
using palpate::test::TemporaryFolder;
using palpate::test::WriteAll;

namespace
{
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
} // namespace

TEST(OutputFolder, CheckingMakesNothing)
{
  const TemporaryFolder folder;
  EXPECT_EQ(MessageOf(CheckOutputFolder, folder / "new/deep"), "");
  EXPECT_EQ(folder.EntryCount(), 0U);
}

TEST(OutputFolder, IsMadeWithThoseAboveAndMayBeThereAlready)
{
  const TemporaryFolder folder;
  MakeOutputFolder(folder / "new/deep");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "new/deep"));
  EXPECT_EQ(MessageOf(MakeOutputFolder, folder / "new/deep"), "");
  EXPECT_EQ(MessageOf(CheckOutputFolder, folder / "new/deep"), "");
}

TEST(OutputFolder, AFileInTheWayIsNamed)
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

TEST(OutputFolder, AFolderThatForbidsWritingIsRefused)
{
  const TemporaryFolder folder;
  chmod(folder.Path().c_str(), 0555);
  for (const auto ask : {CheckOutputFolder, MakeOutputFolder})
  {
    EXPECT_TRUE(HoldsUnprivileged([&] { return !MessageOf(ask, folder / "new").empty(); }));
  }
  chmod(folder.Path().c_str(), 0700);
}

TEST(OutputFolder, RelativeNamesStartAtTheWorkingFolder)
{
  EXPECT_EQ(MessageOf(CheckOutputFolder, "no-such-folder-yet"), "");
}
