#pragma once

#include "PalpateReportModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// A table of many cases as HTML, whose rows are sorted by a click on a column's head: by number if
/// the cells are numbers, otherwise as text. One per page.
class PALPATEREPORT_EXPORT SortableTable
{
public:
  struct Column
  {
    const char* Head;
    const char* Style; ///< "text" or "number"
  };

  explicit SortableTable(std::vector<Column> columns) : Columns(std::move(columns)) {}

  ///@{ The next cell of the last row: plain text, a link to a path that is relative to the page
  /// (none if that is empty), HTML, or a number (a dash for none).
  void AddText(const std::string& text);
  void AddLink(const std::string& text, const std::filesystem::path& path);
  void AddHtml(const std::string& html);
  void AddNumber(double number, int digits);
  ///@}
  /// A cell without content.
  void AddNothing() { this->AddHtml({}); }

  /// The table, with its script. Rows are filled from the left, one after the other.
  std::string Html() const;

private:
  std::vector<Column> Columns;
  std::size_t At = 0; // column of the next cell
  std::string Rows;
};
} // namespace palpate
