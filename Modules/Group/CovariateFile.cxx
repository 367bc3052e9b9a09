#include "CovariateFile.h"

#include "CsvText.h"
#include "InputError.h"
#include "MatchedRows.h"
#include "TableEncoding.h"
#include "WholeFile.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::uintmax_t LargestCovariateFile = 1U << 26U;
constexpr std::size_t MostColumns = 4096;
constexpr std::array<const char*, 6> IdNames{
    {"case", "id", "patient_id", "participant_id", "subject", "subject_id"}};

/// The rows of a file, each with a text for each column.
struct CsvTable
{
  std::vector<std::string> Columns;
  std::vector<std::vector<std::string>> Rows;
};

// "62,5" gives "62.5"; other texts stay.
std::string WithDecimalPoint(std::string text)
{
  const std::size_t comma = text.find(',');
  const bool isNumber =
      comma != std::string::npos && comma > 0 && comma + 1 < text.size() &&
      text.find_first_not_of("0123456789,", text[0] == '-' ? 1 : 0) == std::string::npos &&
      text.find(',', comma + 1) == std::string::npos;
  if (isNumber)
  {
    text[comma] = '.';
  }
  return text;
}

// Without blanks at its ends, also those that do not break a line.
std::string Trimmed(std::string text)
{
  for (std::size_t at = text.find("\xC2\xA0"); at != std::string::npos;
       at = text.find("\xC2\xA0", at))
  {
    text.replace(at, 2, " ");
  }
  const std::size_t first = text.find_first_not_of(" \t");
  const std::size_t last = text.find_last_not_of(" \t");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

CsvTable ReadTable(const std::filesystem::path& file, std::vector<std::string>& notes)
{
  CsvTable table;
  std::string encoding;
  const std::string text =
      TableAsUtf8(ReadWholeFile(file, LargestCovariateFile), file.string(), encoding);
  if (!encoding.empty())
  {
    notes.push_back(file.string() + " was read as " + encoding +
                    "; if its words look wrong, save it as CSV in UTF-8");
  }
  const bool mayHaveDecimalCommas = CsvSeparator(text) == ';';
  ForEachCsvRecord(text,
                   [&](const CsvRecord& record)
                   {
                     if (table.Columns.empty())
                     {
                       table.Columns = record.Columns();
                     }
                     if (table.Columns.size() > MostColumns)
                     {
                       throw InputError(file.string() + " has more than 4096 columns");
                     }
                     std::vector<std::string> row;
                     for (const std::string& column : table.Columns)
                     {
                       const std::string field = Trimmed(*record.Find(column));
                       row.push_back(mayHaveDecimalCommas ? WithDecimalPoint(field) : field);
                     }
                     table.Rows.push_back(std::move(row));
                   });
  if (table.Rows.empty())
  {
    throw InputError(file.string() +
                     " has no rows; covariates are a table with a header and one row per case");
  }
  std::transform(table.Columns.begin(), table.Columns.end(), table.Columns.begin(), &Trimmed);
  return table;
}

std::size_t IdColumn(const CsvTable& table, const std::string& wanted,
                     const std::filesystem::path& file)
{
  const auto placeOf = [&](const std::string& name)
  {
    return static_cast<std::size_t>(std::find(table.Columns.begin(), table.Columns.end(), name) -
                                    table.Columns.begin());
  };
  if (!wanted.empty())
  {
    if (placeOf(wanted) == table.Columns.size())
    {
      throw InputError(file.string() + " has no column " + wanted + " with the cases' names");
    }
    return placeOf(wanted);
  }
  std::size_t first = table.Columns.size();
  for (const char* name : IdNames)
  {
    first = first < table.Columns.size() ? first : placeOf(name);
  }
  return first < table.Columns.size() ? first : 0;
}

} // namespace

CovariateTable ReadCovariates(const std::filesystem::path& file, const std::string& id,
                              const std::vector<std::string>& cases,
                              std::vector<std::string>& notes)
{
  const CsvTable table = ReadTable(file, notes);
  const std::size_t column = IdColumn(table, id, file);
  std::vector<std::string> ids;
  for (const std::vector<std::string>& row : table.Rows)
  {
    ids.push_back(row[column]);
  }
  const MatchedRows found(std::move(ids), cases, file.string(), table.Columns[column]);
  const std::vector<std::optional<std::size_t>>& rows = found.Rows();
  std::vector<std::string> lacking;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    if (!rows[i])
    {
      lacking.push_back(cases[i]);
    }
  }
  if (lacking.size() == cases.size())
  {
    throw InputError(file.string() + ": no " + table.Columns[column] + " (such as " +
                     table.Rows[0][column] + ") is the name of a case (such as " +
                     (cases.empty() ? "" : cases[0]) +
                     ") or a part of it; name the column by --id");
  }
  notes.insert(notes.end(), found.Notes().begin(), found.Notes().end());
  if (!lacking.empty())
  {
    notes.push_back(std::to_string(lacking.size()) +
                    " cases have no row in the covariates, the first is " + lacking.front());
  }
  CovariateTable covariates(cases);
  for (std::size_t k = 0; k < table.Columns.size(); ++k)
  {
    std::vector<std::string> texts;
    for (const std::optional<std::size_t>& row : rows)
    {
      texts.push_back(row ? table.Rows[*row][k] : std::string());
    }
    covariates.Add(table.Columns[k], std::move(texts));
  }
  return covariates;
}
} // namespace palpate
