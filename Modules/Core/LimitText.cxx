#include "LimitText.h"

#include <array>
#include <charconv>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int MostDigits = 17;

bool IsOnSameSide(double shown, double value, double limit)
{
  return (shown < limit) == (value < limit) && (shown > limit) == (value > limit);
}

std::string Text(double value, double limit, std::chars_format format, int digits)
{
  // Digits of the largest double before the point, its sign, the point, and those after it.
  std::array<char, 310 + 2 + MostDigits> characters{};
  char* const begin = characters.data();
  char* const end = begin + characters.size();
  for (; std::isfinite(value) && digits <= MostDigits; ++digits)
  {
    char* const stop = std::to_chars(begin, end, value, format, digits).ptr;
    double shown = 0.0;
    std::from_chars(begin, stop, shown);
    if (IsOnSameSide(shown, value, limit))
    {
      return {begin, stop};
    }
  }
  // The shortest text that reads back to the same bits.
  return {begin, std::to_chars(begin, end, value).ptr};
}
} // namespace

std::string TextAgainstLimit(double value, double limit, int decimals)
{
  return Text(value, limit, std::chars_format::fixed, decimals);
}

std::string SignificantAgainstLimit(double value, double limit, int digits)
{
  return Text(value, limit, std::chars_format::general, digits);
}
} // namespace palpate
