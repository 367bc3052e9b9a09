#pragma once

#include "PalpateReportModule.h"

#include <set>
#include <string>
#include <vector>

namespace palpate
{
/// Rows of text in columns as wide as their widest entry, two spaces apart. A column whose entries
/// are all empty is left out.
class PALPATEREPORT_EXPORT TextTable
{
public:
  /// Names from files are made printable, so that a row stays a line.
  void AddRow(std::vector<std::string> row);
  /// Columns of numbers, counted from 0; the others are aligned left.
  void AlignRight(std::set<std::size_t> columns) { this->RightColumns = std::move(columns); }
  /// The table, one line per row, without trailing spaces.
  std::string Text() const;

private:
  std::vector<std::vector<std::string>> Rows;
  std::set<std::size_t> RightColumns;
};
} // namespace palpate
