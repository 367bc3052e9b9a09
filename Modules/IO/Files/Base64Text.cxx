#include "Base64Text.h"

#include <array>
#include <cstdint>

namespace palpate
{
namespace
{
constexpr int Blank = -1;
constexpr int Foreign = -2;

std::array<int, 256> MakeDigits()
{
  std::array<int, 256> digits;
  digits.fill(Foreign);
  int next = 0;
  for (const char digit :
       std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"))
  {
    digits[static_cast<unsigned char>(digit)] = next++;
  }
  for (const char blank : std::string_view(" \t\r\n"))
  {
    digits[static_cast<unsigned char>(blank)] = Blank;
  }
  return digits;
}
} // namespace

std::optional<std::string> DecodedBase64(std::string_view text)
{
  static const std::array<int, 256> Digits = MakeDigits();
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  unsigned int digits = 0;
  unsigned int padding = 0;
  for (const char letter : text)
  {
    const int digit = Digits[static_cast<unsigned char>(letter)];
    if (digit == Blank)
    {
      continue;
    }
    const bool isPadding = letter == '=' && digits % 4 >= 2;
    if ((digit == Foreign && !isPadding) || (padding > 0 && !isPadding))
    {
      return std::nullopt;
    }
    padding += isPadding ? 1 : 0;
    bits = bits << 6 | static_cast<std::uint32_t>(isPadding ? 0 : digit);
    if (++digits % 4 == 0)
    {
      bytes +=
          {static_cast<char>(bits >> 16), static_cast<char>(bits >> 8), static_cast<char>(bits)};
      // Nothing but blanks may follow padding.
      padding = padding > 0 ? padding + 4 : 0;
    }
  }
  if (digits % 4 != 0)
  {
    return std::nullopt;
  }
  bytes.resize(bytes.size() - padding % 4);
  return bytes;
}
} // namespace palpate
