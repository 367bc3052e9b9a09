#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>

namespace palpate
{
/// The files in which Linux reports the available memory.
struct MemorySources
{
  std::filesystem::path Machine = "/proc/meminfo";
  std::filesystem::path Groups = "/proc/self/cgroup"; ///< control groups of this process
  std::filesystem::path GroupRoot = "/sys/fs/cgroup"; ///< where their file system is mounted
};

/// Bytes that this process can still allocate without swapping: MemAvailable of the machine, or
/// less if a control group of the process (such as a container's) has a lower limit. File pages
/// that the kernel can drop count as free. Returns the largest number if nothing can be read, so
/// that nothing is refused. Source: Linux, Documentation/admin-guide/cgroup-v2.rst and
/// cgroup-v1/memory.rst.
std::uint64_t AvailableMemoryBytes(const MemorySources& sources = {});

/// Throws InputError if reading `dataBytes` of voxels from `file` needs more than `availableBytes`.
/// The voxels count twice, since the format libraries decode into their own buffer.
void CheckMemory(const std::filesystem::path& file, double dataBytes,
                 std::uint64_t availableBytes = AvailableMemoryBytes());

/// Whether an exception of the standard library says that there is not enough memory:
/// std::bad_alloc, or std::length_error for more than any memory holds, whose texts are not for
/// users.
bool SaysMemoryIsShort(const std::exception& error) noexcept;
} // namespace palpate
