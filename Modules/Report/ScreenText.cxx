#include "ScreenText.h"

#include <array>
#include <cstdint>

namespace palpate
{
namespace
{
unsigned char ByteAt(const std::string& text, std::size_t i)
{
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

struct Character
{
  std::size_t Bytes = 1;
  std::uint32_t CodePoint = 0;
  bool IsUtf8 = false;
};

// The character that starts at a byte; the byte alone if it starts none (RFC 3629).
Character CharacterAt(const std::string& text, std::size_t i)
{
  const unsigned char first = ByteAt(text, i);
  if (first < 0x80)
  {
    return {1, first, true};
  }
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  std::uint32_t codePoint = first & (0x7FU >> bytes);
  bool isUtf8 = first >= 0xC2 && first <= 0xF4;
  for (std::size_t next = 1; next < bytes; ++next)
  {
    const unsigned char byte = ByteAt(text, i + next);
    isUtf8 = isUtf8 && (byte & 0xC0U) == 0x80;
    codePoint = codePoint << 6U | (byte & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> Least{{0, 0, 0x80, 0x800, 0x10000}};
  const bool isSurrogate = codePoint >= 0xD800 && codePoint < 0xE000;
  isUtf8 = isUtf8 && codePoint >= Least[bytes] && codePoint < 0x110000 && !isSurrogate;
  return isUtf8 ? Character{bytes, codePoint, true} : Character();
}

// False for controls, line breaks, and characters that are invisible or change the text direction:
// a name must neither leave its line nor look like another one.
bool IsShown(const Character& character)
{
  const std::uint32_t c = character.CodePoint;
  const auto isIn = [c](std::uint32_t first, std::uint32_t last)
  { return c >= first && c <= last; };
  const bool isControl = c < 0x20 || isIn(0x7F, 0x9F) || isIn(0x2028, 0x2029);
  const bool isInvisible =
      c == 0xAD || c == 0x200B || c == 0xFEFF || isIn(0x2060, 0x2064) || isIn(0xE0000, 0xE007F);
  const bool isDirection =
      c == 0x61C || isIn(0x200E, 0x200F) || isIn(0x202A, 0x202E) || isIn(0x2066, 0x206F);
  return character.IsUtf8 && !isControl && !isInvisible && !isDirection;
}
} // namespace

std::string Printable(const std::string& text)
{
  static const char* const Digits = "0123456789abcdef";
  std::string printable;
  for (std::size_t i = 0; i < text.size();)
  {
    const Character character = CharacterAt(text, i);
    const std::size_t end = i + character.Bytes;
    if (IsShown(character))
    {
      printable.append(text, i, character.Bytes);
      i = end;
      continue;
    }
    for (; i < end; ++i)
    {
      printable +=
          std::string("\\x") + Digits[ByteAt(text, i) >> 4U] + Digits[ByteAt(text, i) & 15U];
    }
  }
  return printable;
}

bool IsUtf8(const std::string& text)
{
  std::size_t i = 0;
  while (i < text.size())
  {
    const Character character = CharacterAt(text, i);
    if (!character.IsUtf8)
    {
      return false;
    }
    i += character.Bytes;
  }
  return true;
}

std::string Shortened(const std::string& text, std::size_t characters)
{
  std::size_t count = 0;
  std::size_t cut = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    if ((ByteAt(text, i) & 0xC0U) == 0x80U)
    {
      continue;
    }
    ++count;
    if (count == characters)
    {
      cut = i;
    }
  }
  return count > characters ? text.substr(0, cut) + "\xE2\x80\xA6" : text;
}
} // namespace palpate
