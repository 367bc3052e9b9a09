#pragma once

#include "CsvText.h"

#include <string>
#include <vector>

namespace palpate::test
{
/// All rows of a table written by the program.
inline std::vector<CsvRecord> CsvRecordsIn(const std::string& text)
{
  std::vector<CsvRecord> records;
  ForEachCsvRecord(text, [&](const CsvRecord& record) { records.push_back(record); });
  return records;
}
} // namespace palpate::test
