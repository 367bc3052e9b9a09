#include "TableEncoding.h"

#include "InputError.h"
#include "ScreenText.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace palpate
{
namespace
{
// Windows-1252 from 0x80 to 0x9F (unicode.org, CP1252.TXT); 0 where it has no character.
constexpr std::array<std::uint16_t, 32> WindowsCharacters{
    {0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
     0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
     0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178}};

void AppendUtf8(std::uint32_t codePoint, std::string& text)
{
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (codePoint < 0x80)
  {
    add(codePoint);
    return;
  }
  const unsigned tails = codePoint < 0x800 ? 1 : codePoint < 0x10000 ? 2 : 3;
  constexpr std::array<std::uint32_t, 4> Heads{{0, 0xC0, 0xE0, 0xF0}};
  add(Heads.at(tails) | codePoint >> (6U * tails));
  for (unsigned tail = tails; tail-- > 0;)
  {
    add(0x80U | (codePoint >> (6U * tail) & 0x3FU));
  }
}

std::uint32_t TableByte(const std::string& bytes, std::size_t i)
{
  return static_cast<unsigned char>(bytes[i]);
}

// An unpaired surrogate stays one, which is not UTF-8.
std::string FromUtf16(const std::string& bytes, bool isLittleEndian)
{
  std::string text;
  const auto unitAt = [&](std::size_t i)
  {
    return isLittleEndian ? TableByte(bytes, i) | TableByte(bytes, i + 1) << 8U
                          : TableByte(bytes, i) << 8U | TableByte(bytes, i + 1);
  };
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2)
  {
    std::uint32_t unit = unitAt(i);
    const std::uint32_t next = i + 3 < bytes.size() ? unitAt(i + 2) : 0;
    if (unit >> 10U == 0x36 && next >> 10U == 0x37)
    {
      unit = 0x10000 + ((unit & 0x3FFU) << 10U | (next & 0x3FFU));
      i += 2;
    }
    AppendUtf8(unit, text);
  }
  return text;
}

std::string FromWindows(const std::string& bytes)
{
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    const std::uint32_t byte = TableByte(bytes, i);
    AppendUtf8(byte >= 0x80 && byte < 0xA0 ? WindowsCharacters.at(byte - 0x80) : byte, text);
  }
  return text;
}

bool IsTableControl(char letter)
{
  const auto byte = static_cast<unsigned char>(letter);
  return byte < 0x20 && letter != '\t' && letter != '\n' && letter != '\r';
}

// Characters of XML 1.0.
bool IsPlainTable(const std::string& text)
{
  return IsUtf8(text) && std::none_of(text.begin(), text.end(), &IsTableControl) &&
         text.find("\xEF\xBF\xBE") == std::string::npos &&
         text.find("\xEF\xBF\xBF") == std::string::npos;
}
} // namespace

std::string TableAsUtf8(std::string bytes, const std::string& file, std::string& encoding)
{
  encoding.clear();
  const std::string_view mark = std::string_view(bytes).substr(0, 2);
  if (mark == "\xFF\xFE" || mark == "\xFE\xFF")
  {
    encoding = "UTF-16";
    bytes = FromUtf16(bytes, mark == "\xFF\xFE");
  }
  else if (!IsUtf8(bytes))
  {
    encoding = "WindowsCharacters-1252 (Latin-1)";
    bytes = FromWindows(bytes);
  }
  if (!IsPlainTable(bytes))
  {
    throw InputError(file + " is not plain text; save it as CSV in UTF-8");
  }
  return bytes;
}
} // namespace palpate
