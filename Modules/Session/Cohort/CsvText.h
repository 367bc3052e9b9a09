#pragma once

#include "PalpateSessionModule.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace palpate
{
/// The rows of a comma-separated text (RFC 4180: quotes round fields with commas, line breaks or
/// quotes, which are doubled). Empty lines and a byte-order mark are left out. What CsvLine did to
/// fields that look like formulas is undone.
PALPATESESSION_EXPORT std::vector<std::vector<std::string>> ParseCsv(std::string_view text);

/// One row with its line break. Fields are quoted where they need it, also for programs that
/// separate by semicolons or tabs, and made InertCells: numbers stay numbers, and no text is taken
/// for a formula.
PALPATESESSION_EXPORT std::string CsvLine(const std::vector<std::string>& fields);

/// A row by the names of the head's columns; where it has fewer fields, the others are empty.
using CsvRecord = std::map<std::string, std::string>;

/// The rows below the head, which is the first.
PALPATESESSION_EXPORT std::vector<CsvRecord> ParseCsvRecords(std::string_view text);
} // namespace palpate
