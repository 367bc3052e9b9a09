#pragma once

#include <fstream>
#include <unistd.h>

namespace palpate::test
{
/// Resident memory of this process, MiB; 0 if the system does not report it (Linux:
/// /proc/self/statm).
inline double ResidentMebibytes()
{
  constexpr double Mebi = 1024.0 * 1024.0;
  std::ifstream file("/proc/self/statm");
  double pages = 0.0;
  double resident = 0.0;
  file >> pages >> resident;
  return file ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / Mebi : 0.0;
}
} // namespace palpate::test
