#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace palpate
{
/// Of an even count the upper middle number, of none infinity. Reorders the numbers.
inline double UpperMedian(std::vector<double>& numbers)
{
  if (numbers.empty())
  {
    return std::numeric_limits<double>::infinity();
  }
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}
} // namespace palpate
