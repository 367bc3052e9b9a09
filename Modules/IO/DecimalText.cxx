#include "DecimalText.h"

#include <charconv>
#include <cmath>

namespace palpate
{
namespace
{
template <typename Real>
std::string Shortest(Real value)
{
  char text[40];
  const std::to_chars_result end = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

std::string_view Trimmed(std::string_view text)
{
  const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
  {
    return {};
  }
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// std::from_chars knows no leading plus sign.
std::string_view WithoutPlus(std::string_view text)
{
  const bool plus = text.size() > 1 && text.front() == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}
} // namespace

std::string ExactText(double value)
{
  return Shortest(value);
}
std::string ExactText(float value)
{
  return Shortest(value);
}

std::optional<double> ParseNumber(std::string_view text)
{
  const std::string_view body = WithoutPlus(Trimmed(text));
  double value = 0.0;
  const auto [end, error] = std::from_chars(body.data(), body.data() + body.size(), value);
  if (error != std::errc() || end != body.data() + body.size() || !std::isfinite(value))
  {
    return std::nullopt;
  }
  return value;
}

std::optional<int> ParseInteger(std::string_view text)
{
  const std::string_view body = WithoutPlus(Trimmed(text));
  int value = 0;
  const auto [end, error] = std::from_chars(body.data(), body.data() + body.size(), value);
  if (error != std::errc() || end != body.data() + body.size())
  {
    return std::nullopt;
  }
  return value;
}
} // namespace palpate
