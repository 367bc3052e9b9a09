#include "PeriodStatistics.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
int FloorLog2(std::uint64_t value) noexcept
{
  return 63 - __builtin_clzll(value);
}
} // namespace

std::size_t PeriodStatistics::ClassOf(std::int64_t duration) noexcept
{
  const auto value = static_cast<std::uint64_t>(duration);
  if (value < (1u << ClassBits))
  {
    return static_cast<std::size_t>(value);
  }
  const int octave = FloorLog2(value);
  const std::uint64_t within = (value >> (octave - ClassBits)) - (1u << ClassBits);
  return (static_cast<std::size_t>(octave - ClassBits + 1) << ClassBits) + within;
}

std::int64_t PeriodStatistics::LargestOf(std::size_t index) noexcept
{
  const std::size_t octave = index >> ClassBits;
  if (octave == 0)
  {
    return static_cast<std::int64_t>(index);
  }
  const std::uint64_t leading = (index & ((1u << ClassBits) - 1)) + (1u << ClassBits);
  return static_cast<std::int64_t>(((leading + 1) << (octave - 1)) - 1);
}

void PeriodStatistics::Add(std::int64_t duration) noexcept
{
  const std::int64_t d = std::max<std::int64_t>(duration, 0);
  ++this->Counts[ClassOf(d)];
  ++this->Total;
  this->Least = std::min(this->Least, d);
  this->Largest = std::max(this->Largest, d);
  this->Sum += static_cast<double>(d);
}

double PeriodStatistics::Mean() const noexcept
{
  return this->Total > 0 ? this->Sum / static_cast<double>(this->Total) : 0.0;
}

std::int64_t PeriodStatistics::Quantile(double fraction) const noexcept
{
  const double wanted = std::ceil(fraction * static_cast<double>(this->Total));
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < ClassCount; ++i)
  {
    seen += this->Counts[i];
    if (seen > 0 && static_cast<double>(seen) >= wanted)
    {
      return std::clamp(LargestOf(i), this->Min(), this->Largest);
    }
  }
  return this->Largest;
}
} // namespace palpate
