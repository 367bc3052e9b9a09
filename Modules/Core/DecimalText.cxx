#include "DecimalText.h"

#include <charconv>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int MostDigits = 17; // that a double needs

template <typename Real>
std::string Shortest(Real value)
{
  char text[40];
  const std::to_chars_result end = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

// As printf does it with these digits.
std::string Rounded(double value, std::chars_format format, int digits)
{
  if (!std::isfinite(value))
  {
    return "\xE2\x80\x93"; // en dash, UTF-8
  }
  // Digits of the largest double before the point, its sign, the point, and those after it.
  std::string text(310 + 2 + static_cast<std::size_t>(digits), '\0');
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format, digits);
  text.resize(static_cast<std::size_t>(end.ptr - text.data()));
  return text;
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

bool IsOnSameSide(double shown, double value, double limit)
{
  return (shown < limit) == (value < limit) && (shown > limit) == (value > limit);
}

std::string AgainstLimit(double value, double limit, int digits, std::string (*write)(double, int))
{
  for (; std::isfinite(value) && digits <= MostDigits; ++digits)
  {
    std::string text = write(value, digits);
    // The largest numbers may round to text that is too large.
    const std::optional<double> shown = ParseNumber(text);
    if (shown && IsOnSameSide(*shown, value, limit))
    {
      return text;
    }
  }
  return ExactText(value);
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

std::string FixedText(double value, int decimals)
{
  const std::string text = Rounded(value, std::chars_format::fixed, decimals);
  const bool isZero = text.front() == '-' && text.find_first_of("123456789") == std::string::npos;
  return isZero ? text.substr(1) : text;
}

std::string SignificantText(double value, int digits)
{
  return Rounded(value, std::chars_format::general, digits);
}

std::string TextAgainstLimit(double value, double limit, int decimals)
{
  return AgainstLimit(value, limit, decimals, &FixedText);
}

std::string SignificantAgainstLimit(double value, double limit, int digits)
{
  return AgainstLimit(value, limit, digits, &SignificantText);
}

std::string CountText(std::int64_t count, std::string_view one, std::string_view several)
{
  return std::to_string(count).append(" ").append(count == 1 ? one : several);
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
