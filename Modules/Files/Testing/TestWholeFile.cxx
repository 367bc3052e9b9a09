#include "FileSizeLimit.h"
#include "InputError.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <gtest/gtest.h>

namespace palpate::whole_file_test
{
namespace
{
using palpate::test::FileSizeLimit;
using palpate::test::ReadAll;
using palpate::test::TemporaryFolder;
using palpate::test::WriteAll;

TEST(WholeFile, BytesRoundTrip)
{
  const TemporaryFolder folder;
  std::string bytes;
  for (int i = 0; i < 70000; ++i)
  {
    bytes.push_back(static_cast<char>(i * 31 % 256));
  }
  WriteWholeFile(folder / "a", bytes);
  EXPECT_EQ(ReadWholeFile(folder / "a", 70000), bytes);
}

TEST(WholeFile, FullDiskKeepsOldFileOnly)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a", "old");
  {
    const FileSizeLimit limit(4096);
    EXPECT_THROW(WriteWholeFile(folder / "a", std::string(100000, 'x')), InputError);
  }
  EXPECT_EQ(ReadAll(folder / "a"), "old");
  EXPECT_EQ(folder.EntryCount(), 1u);
}

TEST(WholeFile, RejectsMissingEmptyFolderAndTooLarge)
{
  const TemporaryFolder folder;
  WriteAll(folder / "empty", "");
  WriteAll(folder / "large", "12345");
  EXPECT_THROW(ReadWholeFile(folder / "none", 100), InputError);
  EXPECT_THROW(ReadWholeFile(folder / "empty", 100), InputError);
  EXPECT_THROW(ReadWholeFile(folder.Path(), 100), InputError);
  EXPECT_THROW(ReadWholeFile(folder / "large", 4), InputError);
  EXPECT_EQ(ReadWholeFile(folder / "large", 5), "12345");
}
} // namespace
} // namespace palpate::whole_file_test
