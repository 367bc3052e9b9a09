#include "FiniteNumber.h"

#include "DecimalText.h"

#include <limits>

namespace palpate::cli
{
FiniteNumber::FiniteNumber(double low, double high, bool lowIsIn, const std::string& range)
    : CLI::Validator(range)
{
  this->func_ = [low, high, lowIsIn, range](const std::string& word)
  {
    const std::optional<double> number = ParseNumber(word);
    const bool good = number && *number <= high && (lowIsIn ? *number >= low : *number > low);
    return good ? std::string() : word + " is not a number " + range;
  };
}

FiniteNumber FiniteNumber::Between(double low, double high)
{
  return {low, high, true, "from " + SignificantText(low) + " to " + SignificantText(high)};
}

FiniteNumber FiniteNumber::Positive()
{
  return {0.0, std::numeric_limits<double>::max(), false, "above 0"};
}

FiniteNumber FiniteNumber::Any()
{
  constexpr double Largest = std::numeric_limits<double>::max();
  return {-Largest, Largest, true, "that is finite"};
}
} // namespace palpate::cli
