#include "MemoryCheck.h"

#include "Refusal.h"

#include <fstream>
#include <limits>
#include <string>

namespace palpate
{
std::uint64_t AvailableMemoryBytes(const std::filesystem::path& meminfo)
{
  std::ifstream stream(meminfo);
  std::string key;
  std::uint64_t kibibytes = 0;
  while (stream >> key)
  {
    if (key == "MemAvailable:" && stream >> kibibytes)
    {
      return kibibytes * 1024;
    }
    stream.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return std::numeric_limits<std::uint64_t>::max();
}

void CheckMemory(const std::filesystem::path& file, double dataBytes, std::uint64_t availableBytes)
{
  const double needed = 2.0 * dataBytes;
  if (!(needed <= static_cast<double>(availableBytes)))
  {
    Refuse(file,
           "needs about " + NumberText(needed / 1e9) + " GB of memory to read and " +
               NumberText(static_cast<double>(availableBytes) / 1e9) + " GB are free",
           "crop or resample it, or use a larger machine");
  }
}
} // namespace palpate
