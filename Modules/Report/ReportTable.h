#pragma once

#include "PalpateReportModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
struct ReportFigure;

/// A table of a page with a head. Rows are filled from the left, one after the other; texts are
/// plain. Columns of numbers are aligned right, as their first cell says. A sortable table (one per
/// page) is sorted by a click on a column's head: by number if the cells are numbers, otherwise as
/// text.
class PALPATEREPORT_EXPORT ReportTable
{
public:
  explicit ReportTable(std::vector<std::string> heads, bool isSortable = false)
      : Heads(std::move(heads)), IsSortable(isSortable)
  {
  }

  ///@{ The next cell: a text, a link to a path relative to the page (a text if that is empty), a
  /// text in a verdict's style ("good", "poor" or "bad") with a tool tip, a figure; a number as
  /// text, or with fixed digits (a dash if it is not finite), or none.
  ReportTable& Text(const std::string& text);
  ReportTable& Link(const std::string& text, const std::filesystem::path& path);
  ReportTable& Marked(const std::string& style, const std::string& text,
                      const std::string& toolTip = {});
  ReportTable& Image(const ReportFigure& figure);
  ReportTable& Value(const std::string& number);
  ReportTable& Number(double number, int digits);
  ReportTable& Nothing() { return this->Value({}); }
  ///@}

  std::string Html() const;

private:
  ReportTable& Cell(const char* style, const std::string& html);

  std::vector<std::string> Heads;
  bool IsSortable;
  std::vector<const char*> Styles; // of the first row's cells
  std::size_t At = 0;              // column of the next cell
  std::string Rows;
};
} // namespace palpate
