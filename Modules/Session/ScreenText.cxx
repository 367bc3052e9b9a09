#include "ScreenText.h"

namespace palpate
{
namespace
{
unsigned char ByteAt(const std::string& text, std::size_t i)
{
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

// The count of bytes of a control character that starts here: ASCII's one, or U+0080 to U+009F.
std::size_t ControlBytes(const std::string& text, std::size_t i)
{
  const unsigned char byte = ByteAt(text, i);
  const unsigned char next = ByteAt(text, i + 1);
  if (byte == 0xC2 && next >= 0x80 && next < 0xA0)
  {
    return 2;
  }
  return byte < 0x20 || byte == 0x7F ? 1 : 0;
}
} // namespace

std::string Printable(const std::string& text)
{
  static const char* const Digits = "0123456789abcdef";
  std::string printable;
  for (std::size_t i = 0; i < text.size();)
  {
    const std::size_t control = ControlBytes(text, i);
    if (control == 0)
    {
      printable += text[i++];
      continue;
    }
    for (const std::size_t end = i + control; i < end; ++i)
    {
      printable +=
          std::string("\\x") + Digits[ByteAt(text, i) >> 4U] + Digits[ByteAt(text, i) & 15U];
    }
  }
  return printable;
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
