#include "AtomicFile.h"
#include "InputError.h"
#include "TemporaryFolder.h"
#include "Unprivileged.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <vector>

namespace palpate::atomic_file_test
{
namespace
{
// The files that this program synchronised with the disk, in order.
std::vector<std::filesystem::path> Synced;
} // namespace

// Replaces the C library's function in this program.
extern "C" __attribute__((visibility("default"))) int fsync(int file)
{
  std::error_code ignored;
  Synced.push_back(std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file), ignored));
  return static_cast<int>(syscall(SYS_fsync, file));
}

namespace
{
using palpate::test::HoldsUnprivileged;
using palpate::test::ReadAll;
using palpate::test::TemporaryFolder;
using palpate::test::WriteAll;

std::string MessageOf(const std::filesystem::path& path)
{
  try
  {
    AtomicFile file(path);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "no error";
}

TEST(AtomicFile, CommitLeavesOnlyNamedFile)
{
  const TemporaryFolder folder;
  AtomicFile file(folder / "a.json");
  WriteAll(file.TemporaryPath(), "new");
  file.Commit();
  EXPECT_EQ(ReadAll(folder / "a.json"), "new");
  EXPECT_EQ(folder.EntryCount(), 1u);
}

TEST(AtomicFile, AbandonedFileLeavesFolderUnchanged)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.json", "old");
  {
    AtomicFile file(folder / "a.json");
    WriteAll(file.TemporaryPath(), "half of the n");
  }
  EXPECT_EQ(ReadAll(folder / "a.json"), "old");
  EXPECT_EQ(folder.EntryCount(), 1u);
}

TEST(AtomicFile, KeepsOldContentUntilCommit)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.json", "old");
  AtomicFile file(folder / "a.json");
  WriteAll(file.TemporaryPath(), "new");
  EXPECT_EQ(ReadAll(folder / "a.json"), "old");
  file.Commit();
  EXPECT_EQ(ReadAll(folder / "a.json"), "new");
}

TEST(AtomicFile, TemporaryNameKeepsEnding)
{
  const TemporaryFolder folder;
  const AtomicFile file(folder / "a.seg.nii.gz");
  const std::string name = file.TemporaryPath().filename().string();
  EXPECT_EQ(name.substr(name.size() - 11), ".seg.nii.gz");
}

TEST(AtomicFile, TemporaryFileIsInSameFolder)
{
  const TemporaryFolder folder;
  const AtomicFile file(folder / "a.json");
  EXPECT_EQ(file.TemporaryPath().parent_path(), folder.Path());
}

TEST(AtomicFile, WritesLongestFileName)
{
  const TemporaryFolder folder;
  const std::string name = std::string(250, 'x') + ".json"; // 255 bytes, the maximum
  AtomicFile file(folder / name);
  file.Commit();
  EXPECT_TRUE(std::filesystem::exists(folder / name));
}

TEST(AtomicFile, ConcurrentWritersDoNotMix)
{
  const TemporaryFolder folder;
  AtomicFile first(folder / "a");
  AtomicFile second(folder / "a");
  WriteAll(first.TemporaryPath(), "first");
  WriteAll(second.TemporaryPath(), "second");
  first.Commit();
  second.Commit();
  EXPECT_EQ(ReadAll(folder / "a"), "second");
}

TEST(AtomicFile, ReplacesSymbolicLinkAndNotItsTarget)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "elsewhere");
  WriteAll(folder / "elsewhere/target", "old");
  std::filesystem::create_symlink("elsewhere/target", folder / "link");
  AtomicFile file(folder / "link");
  WriteAll(file.TemporaryPath(), "new");
  file.Commit();
  EXPECT_FALSE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(ReadAll(folder / "link"), "new");
  EXPECT_EQ(ReadAll(folder / "elsewhere/target"), "old");
}

TEST(AtomicFile, KeepsPermissionsOfExistingFile)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a", "old");
  chmod((folder / "a").c_str(), 0640);
  AtomicFile(folder / "a").Commit();
  struct stat status = {};
  ASSERT_EQ(stat((folder / "a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(AtomicFile, NewFilePermissionsFollowUmask)
{
  const TemporaryFolder folder;
  const mode_t mask = umask(0022);
  AtomicFile(folder / "a").Commit();
  umask(mask);
  struct stat status = {};
  ASSERT_EQ(stat((folder / "a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0644u);
}

TEST(AtomicFile, NamesMissingFolder)
{
  const TemporaryFolder folder;
  const std::string message = MessageOf(folder / "none/a.json");
  EXPECT_NE(message.find("there is no folder"), std::string::npos) << message;
  EXPECT_NE(message.find("none"), std::string::npos) << message;
  EXPECT_EQ(folder.EntryCount(), 0u);
}

TEST(AtomicFile, RejectsFolderOfSameName)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a.json");
  EXPECT_NE(MessageOf(folder / "a.json").find("it is a folder"), std::string::npos);
}

TEST(AtomicFile, RejectsDevice)
{
  EXPECT_NE(MessageOf("/dev/null").find("not a regular file"), std::string::npos);
}

TEST(AtomicFile, RejectsEmptyName)
{
  EXPECT_NE(MessageOf("").find("has no file name"), std::string::npos);
}

TEST(AtomicFile, RejectsUnwritableFolder)
{
  const TemporaryFolder folder;
  chmod(folder.Path().c_str(), 0555);
  EXPECT_TRUE(HoldsUnprivileged(
      [&] { return MessageOf(folder / "a").find("cannot be written") != std::string::npos; }));
  chmod(folder.Path().c_str(), 0700);
}

TEST(AtomicFile, SyncsContentBeforeRename)
{
  const TemporaryFolder folder;
  AtomicFile file(folder / "a");
  WriteAll(file.TemporaryPath(), "new");
  const std::filesystem::path temporary = std::filesystem::canonical(file.TemporaryPath());
  Synced.clear();
  file.Commit();
  const std::vector<std::filesystem::path> expected{temporary, temporary.parent_path()};
  EXPECT_EQ(Synced, expected) << "the file under its temporary name, then the folder";
}
} // namespace
} // namespace palpate::atomic_file_test
