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
/// One row with its line break. Fields are quoted if needed, also for programs that separate by
/// semicolons or tabs, and passed through InertCell: numbers remain numbers, and no text is
/// interpreted as a formula.
PALPATEREPORT_EXPORT std::string CsvLine(const std::vector<std::string>& fields);

/// A row, accessed by column names.
class PALPATEREPORT_EXPORT CsvRecord
{
public:
  using Places = std::map<std::string, std::size_t>;
  CsvRecord(std::shared_ptr<const Places> head, std::vector<std::string> fields)
      : Head(std::move(head)), Fields(std::move(fields))
  {
  }

  /// Null if the head has no such column; empty if the row has fewer fields.
  const std::string* Find(const std::string& column) const;
  /// The head's columns in their order; of two with one name the last.
  std::vector<std::string> Columns() const;

private:
  std::shared_ptr<const Places> Head;
  std::vector<std::string> Fields;
};

/// What separates the fields of a text: what a first line such as `sep=;` says, otherwise of comma,
/// semicolon and tab the one that its header has most of outside of quotes. A comma if it has none.
PALPATEREPORT_EXPORT char CsvSeparator(std::string_view text);

/// Calls `take` with each row of a text with separated fields (CsvSeparator; RFC 4180: quotes
/// around fields with separators, line breaks or quotes, which are doubled) after the header. Lines
/// end with LF, CR LF or CR. Empty lines, a byte-order mark and a first line with the separator are
/// ignored. CsvLine's changes to fields that look like formulas are
/// undone. Keeps one row at a time: a text of commas would need many times its size.
PALPATEREPORT_EXPORT void ForEachCsvRecord(std::string_view text,
                                           const std::function<void(const CsvRecord&)>& take);
} // namespace palpate
