#include "TextTable.h"

#include "ScreenText.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace palpate
{
namespace
{
// Characters on the screen: bytes that do not continue a UTF-8 character.
std::size_t Width(const std::string& text)
{
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

std::vector<std::size_t> ColumnWidths(const std::vector<std::vector<std::string>>& rows)
{
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
  {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t column = 0; column < row.size(); ++column)
    {
      widths[column] = std::max(widths[column], Width(row[column]));
    }
  }
  return widths;
}
} // namespace

void TextTable::AddRow(std::vector<std::string> row)
{
  std::transform(row.begin(), row.end(), row.begin(), Printable);
  this->Rows.push_back(std::move(row));
}

std::string TextTable::Text() const
{
  const std::vector<std::size_t> widths = ColumnWidths(this->Rows);
  std::string text;
  for (const auto& row : this->Rows)
  {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column)
    {
      if (widths[column] == 0)
      {
        continue;
      }
      const std::string padding(widths[column] - Width(row[column]), ' ');
      const bool right = this->RightColumns.count(column) > 0;
      line += (line.empty() ? "" : "  ") + (right ? padding : "") + row[column] +
              (right ? "" : padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}
} // namespace palpate
