#include "HtmlText.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace palpate
{
namespace
{
const char* const Replacement = "\xEF\xBF\xBD"; // U+FFFD, UTF-8

std::string EscapeAscii(char c)
{
  switch (c)
  {
  case '&':
    return "&amp;";
  case '<':
    return "&lt;";
  case '>':
    return "&gt;";
  case '"':
    return "&quot;";
  case '\'':
    return "&#39;";
  case '\n':
  case '\t':
    return " ";
  default:
    return c >= 0x20 && c != 0x7F ? std::string(1, c) : std::string();
  }
}

// Bytes of the UTF-8 character that starts at `at`; 0 if it is invalid, such as overlong forms,
// surrogates and values beyond U+10FFFF.
std::size_t Utf8Length(const std::string& text, std::size_t at)
{
  const auto byte = [&text](std::size_t i)
  { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned int first = byte(at);
  if (first < 0x80)
  {
    return 1;
  }
  const std::size_t length = first >= 0xC2 && first <= 0xDF   ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((byte(at + i) & 0xC0U) != 0x80)
    {
      return 0;
    }
  }
  const unsigned int second = byte(at + 1);
  const bool isForbidden = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                           (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return isForbidden ? 0 : length;
}
} // namespace

std::string EscapeHtml(const std::string& text)
{
  std::string escaped;
  escaped.reserve(text.size());
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t length = Utf8Length(text, at);
    if (length == 0)
    {
      escaped += Replacement;
      ++at;
    }
    else if (length == 1)
    {
      escaped += EscapeAscii(text[at]);
      ++at;
    }
    else
    {
      escaped.append(text, at, length);
      at += length;
    }
  }
  return escaped;
}

std::string HtmlTable(const std::string& caption, const HtmlRows& rows)
{
  std::string html = "<table><caption>" + EscapeHtml(caption) + "</caption><tbody>\n";
  for (const auto& [name, value] : rows)
  {
    html += "<tr><th scope=\"row\">" + EscapeHtml(name) + "</th><td>" + EscapeHtml(value) +
            "</td></tr>\n";
  }
  return html + "</tbody></table>\n";
}
} // namespace palpate
