#pragma once

#include <algorithm>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace palpate
{
/// Lowers a limit of this process (RLIMIT_AS, ...), as far as it may.
inline void LimitResource(int resource, rlim_t most)
{
  rlimit limit{};
  getrlimit(static_cast<__rlimit_resource>(resource), &limit);
  limit.rlim_cur = std::min(most, limit.rlim_max);
  setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

/// What this process has mapped now.
inline rlim_t MappedBytes()
{
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

/// What it has used until now.
inline rlim_t ProcessorSeconds()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec);
}
} // namespace palpate
