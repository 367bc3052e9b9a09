#include "AvailableMemory.h"
#include "MessageOf.h"
#include "TemporaryFolder.h"

#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace palpate::available_memory_test
{
namespace
{
using namespace palpate::test;

constexpr std::uint64_t Kibibyte = 1024;

// A machine with 300 kB left, and groups defined by the test.
class AvailableMemory : public testing::Test
{
protected:
  AvailableMemory()
  {
    this->Write("meminfo", "MemTotal:  900 kB\nMemFree:   100 kB\nMemAvailable:   300 kB\n");
  }
  void Write(const std::string& name, const std::string& text) const
  {
    const auto file = this->Folder / name;
    std::filesystem::create_directories(file.parent_path());
    WriteAll(file, text);
  }
  std::uint64_t Left() const
  {
    return AvailableMemoryBytes(
        {this->Folder / "meminfo", this->Folder / "cgroup", this->Folder / "groups"});
  }

private:
  TemporaryFolder Folder;
};

TEST_F(AvailableMemory, UsesMachineWithoutGroups)
{
  EXPECT_EQ(this->Left(), 300 * Kibibyte);
}

TEST_F(AvailableMemory, IsUnlimitedIfNothingCanBeRead)
{
  EXPECT_EQ(AvailableMemoryBytes({"/no/such/meminfo", "/no/such/cgroup", "/no/such/folder"}),
            std::numeric_limits<std::uint64_t>::max());
}

TEST_F(AvailableMemory, UsesGroupLimitVersion2)
{
  this->Write("cgroup", "0::/user/program\n");
  this->Write("groups/user/program/memory.max", "204800\n");
  this->Write("groups/user/program/memory.current", "102400\n");
  EXPECT_EQ(this->Left(), 100 * Kibibyte);
}

TEST_F(AvailableMemory, UsesSmallestLimitOfParentGroups)
{
  this->Write("cgroup", "0::/user/program\n");
  this->Write("groups/user/program/memory.max", "max\n");
  this->Write("groups/user/program/memory.current", "102400\n");
  this->Write("groups/user/memory.max", "112640\n");
  this->Write("groups/user/memory.current", "102400\n");
  EXPECT_EQ(this->Left(), 10 * Kibibyte);
}

TEST_F(AvailableMemory, UsesContainerLimitForHostPath)
{
  this->Write("cgroup", "0::/docker/0123456789\n");
  this->Write("groups/memory.max", "204800\n");
  this->Write("groups/memory.current", "153600\n");
  EXPECT_EQ(this->Left(), 50 * Kibibyte);
}

TEST_F(AvailableMemory, UsesGroupLimitVersion1)
{
  this->Write("cgroup", "5:cpu,cpuacct:/a\n4:memory:/a/b\n0::/\n");
  this->Write("groups/memory/memory.limit_in_bytes", "9223372036854771712\n");
  this->Write("groups/memory/memory.usage_in_bytes", "500000\n");
  this->Write("groups/memory/a/b/memory.limit_in_bytes", "204800\n");
  this->Write("groups/memory/a/b/memory.usage_in_bytes", "184320\n");
  EXPECT_EQ(this->Left(), 20 * Kibibyte);
}

TEST_F(AvailableMemory, CachedFilesCountAsFree)
{
  this->Write("cgroup", "0::/a\n");
  this->Write("groups/a/memory.max", "204800\n");
  this->Write("groups/a/memory.current", "194560\n");
  this->Write("groups/a/memory.stat", "anon 1024\nfile 92160\ninactive_file 81920\n");
  EXPECT_EQ(this->Left(), 90 * Kibibyte);
}

TEST_F(AvailableMemory, IsZeroInFullGroup)
{
  this->Write("cgroup", "0::/a\n");
  this->Write("groups/a/memory.max", "204800\n");
  this->Write("groups/a/memory.current", "204900\n");
  EXPECT_EQ(this->Left(), 0U);
}

TEST_F(AvailableMemory, UsesMachineIfGroupHasMore)
{
  this->Write("cgroup", "0::/a\n");
  this->Write("groups/a/memory.max", "204800000\n");
  this->Write("groups/a/memory.current", "0\n");
  EXPECT_EQ(this->Left(), 300 * Kibibyte);
}

TEST_F(AvailableMemory, CountsDataTwice)
{
  EXPECT_NO_THROW(CheckMemory("x.nii", 500.0, 1000));
  EXPECT_EQ(
      MessageOf([] { CheckMemory("x.nii", 2e9, 1000000000); }),
      "x.nii needs about 4 GB of memory to read but 1 GB are free; crop or resample it, or use "
      "a larger machine.");
  EXPECT_NE(MessageOf([] { CheckMemory("x.nii", std::numeric_limits<double>::quiet_NaN(), 1000); }),
            "no error");
}

// The texts of these exceptions are the library's, not sentences for users.
TEST_F(AvailableMemory, KnowsExceptionsOfSizesThatNoMemoryHolds)
{
  std::string text;
  std::vector<double> numbers;
  EXPECT_TRUE(SaysMemoryIsShort(std::bad_alloc()));
  for (const auto& grow :
       std::vector<std::function<void()>>{[&] { numbers.reserve(std::size_t{1} << 62U); },
                                          [&] { text.reserve(text.max_size() + 1); }})
  {
    try
    {
      grow();
      FAIL();
    }
    catch (const std::exception& error)
    {
      EXPECT_TRUE(SaysMemoryIsShort(error)) << error.what();
    }
  }
  EXPECT_FALSE(SaysMemoryIsShort(std::runtime_error("other")));
}
} // namespace
} // namespace palpate::available_memory_test
