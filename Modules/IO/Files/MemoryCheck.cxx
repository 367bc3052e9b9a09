#include "MemoryCheck.h"

#include "DecimalText.h"
#include "Refusal.h"

#include <string>

namespace palpate
{
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
} // namespace palpate
