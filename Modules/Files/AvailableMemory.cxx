#include "AvailableMemory.h"

#include "DecimalText.h"
#include "Refusal.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

namespace palpate
{
namespace
{
constexpr std::uint64_t Unlimited = std::numeric_limits<std::uint64_t>::max();

// File names of a memory group in one version of control groups.
struct GroupFiles
{
  const char* Limit;
  const char* Usage;
  const char* DroppableKey; // in memory.stat
};
constexpr GroupFiles Version1{"memory.limit_in_bytes", "memory.usage_in_bytes",
                              "total_inactive_file"};
constexpr GroupFiles Version2{"memory.max", "memory.current", "inactive_file"};

// The number after a key, or the first number of the file if the key is empty. Empty for "max".
std::optional<std::uint64_t> NumberIn(const std::filesystem::path& file, const std::string& key)
{
  std::ifstream stream(file);
  std::uint64_t number = 0;
  std::string word;
  while (!key.empty() && word != key && stream >> word)
  {
  }
  return stream >> number ? std::optional<std::uint64_t>(number) : std::nullopt;
}

std::uint64_t LeftInGroup(const std::filesystem::path& folder, const GroupFiles& files)
{
  const auto limit = NumberIn(folder / files.Limit, {});
  const auto usage = NumberIn(folder / files.Usage, {});
  if (!limit || !usage)
  {
    return Unlimited;
  }
  const std::uint64_t droppable = NumberIn(folder / "memory.stat", files.DroppableKey).value_or(0);
  const std::uint64_t used = *usage - std::min(droppable, *usage);
  return *limit - std::min(used, *limit);
}

// The least of a group and its parents. In a container the path may be the host's, of which only
// the last folders, or none, are mounted.
std::uint64_t LeftUpwards(const std::filesystem::path& root, std::filesystem::path group,
                          const GroupFiles& files)
{
  std::uint64_t left = LeftInGroup(root, files);
  for (group = group.relative_path(); !group.empty(); group = group.parent_path())
  {
    left = std::min(left, LeftInGroup(root / group, files));
  }
  return left;
}
} // namespace

std::uint64_t AvailableMemoryBytes(const MemorySources& sources)
{
  const auto kibibytes = NumberIn(sources.Machine, "MemAvailable:");
  std::uint64_t left = kibibytes ? *kibibytes * 1024 : Unlimited;
  std::ifstream groups(sources.Groups);
  // number:controllers:path
  for (std::string number, controllers, path; std::getline(groups, number, ':') &&
                                              std::getline(groups, controllers, ':') &&
                                              std::getline(groups, path);)
  {
    if (controllers.empty())
    {
      left = std::min(left, LeftUpwards(sources.GroupRoot, path, Version2));
    }
    else if (("," + controllers + ",").find(",memory,") != std::string::npos)
    {
      left = std::min(left, LeftUpwards(sources.GroupRoot / "memory", path, Version1));
    }
  }
  return left;
}

void CheckMemory(const std::filesystem::path& file, double dataBytes, std::uint64_t availableBytes)
{
  const double needed = 2.0 * dataBytes;
  if (!(needed <= static_cast<double>(availableBytes)))
  {
    Refuse(file,
           "needs about " + SignificantText(needed / 1e9) + " GB of memory to read but " +
               SignificantText(static_cast<double>(availableBytes) / 1e9) + " GB are free",
           "crop or resample it, or use a larger machine");
  }
}

bool SaysMemoryIsShort(const std::exception& error) noexcept
{
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
         dynamic_cast<const std::length_error*>(&error) != nullptr;
}
} // namespace palpate
