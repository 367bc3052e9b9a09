#pragma once

#include "PalpateReportModule.h"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palpate
{
/// The rows of a comma-separated text (RFC 4180: quotes round fields with commas, line breaks or
/// quotes, which are doubled). Empty lines and a byte-order mark are left out. What CsvLine did to
/// fields that look like formulas is undone.
PALPATEREPORT_EXPORT std::vector<std::vector<std::string>> ParseCsv(std::string_view text);

/// One row with its line break. Fields are quoted where they need it, also for programs that
/// separate by semicolons or tabs, and made InertCells: numbers stay numbers, and no text is taken
/// for a formula.
PALPATEREPORT_EXPORT std::string CsvLine(const std::vector<std::string>& fields);

/// A row by the names of the head's columns.
class PALPATEREPORT_EXPORT CsvRecord
{
public:
  using Columns = std::map<std::string, std::size_t>;
  CsvRecord(std::shared_ptr<const Columns> head, std::vector<std::string> fields)
      : Head(std::move(head)), Fields(std::move(fields))
  {
  }

  /// Null if the head has no such column; empty if the row has fewer fields.
  const std::string* Find(const std::string& column) const;

private:
  std::shared_ptr<const Columns> Head;
  std::vector<std::string> Fields;
};

/// Calls `take` with each row below the head, which is the first. Keeps one row at a time: a text
/// of commas would take many times its size.
PALPATEREPORT_EXPORT void ForEachCsvRecord(std::string_view text,
                                           const std::function<void(const CsvRecord&)>& take);
} // namespace palpate
