#include "CovariateFile.h"

#include "CsvText.h"
#include "InputError.h"
#include "WholeFile.h"

#include <algorithm>
#include <array>
#include <cctype>
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

// participant_id of BIDS has it, a pattern such as sub-{id} leaves it out.
const std::string BidsPrefix = "sub-";

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

CsvTable ReadTable(const std::filesystem::path& file)
{
  CsvTable table;
  const std::string text = ReadWholeFile(file, LargestCovariateFile);
  if (text.find('\0') != std::string::npos)
  {
    throw InputError(file.string() + " is not plain text; save it as CSV in UTF-8");
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
                       const std::string& field = *record.Find(column);
                       row.push_back(mayHaveDecimalCommas ? WithDecimalPoint(field) : field);
                     }
                     table.Rows.push_back(std::move(row));
                   });
  if (table.Rows.empty())
  {
    throw InputError(file.string() +
                     " has no rows; covariates are a table with a header and one row per case");
  }
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

bool HasWholePart(const std::string& name, const std::string& part)
{
  const auto isPartOfWord = [&](std::size_t place)
  { return place < name.size() && std::isalnum(static_cast<unsigned char>(name[place])) != 0; };
  for (std::size_t at = name.find(part); at != std::string::npos; at = name.find(part, at + 1))
  {
    if ((at == 0 || !isPartOfWord(at - 1)) && !isPartOfWord(at + part.size()))
    {
      return true;
    }
  }
  return false;
}

std::optional<std::size_t> RowOf(const std::string& name, const CsvTable& table, std::size_t column,
                                 const std::filesystem::path& file)
{
  std::optional<std::size_t> best;
  bool isUnique = true;
  for (std::size_t row = 0; row < table.Rows.size(); ++row)
  {
    const std::string& id = table.Rows[row][column];
    if (id.empty() || !(HasWholePart(name, id) || id == BidsPrefix + name))
    {
      continue;
    }
    const std::size_t known = best ? table.Rows[*best][column].size() : 0;
    if (id.size() >= known)
    {
      isUnique = id.size() > known;
      best = row;
    }
  }
  if (!isUnique)
  {
    throw InputError(file.string() + ": several rows have the " + table.Columns[column] + " " +
                     table.Rows[*best][column] + " of case " + name +
                     "; name a column with one value per case by --id");
  }
  return best;
}
} // namespace

CovariateTable ReadCovariates(const std::filesystem::path& file, const std::string& id,
                              const std::vector<std::string>& cases,
                              std::vector<std::string>& notes)
{
  const CsvTable table = ReadTable(file);
  const std::size_t column = IdColumn(table, id, file);
  std::vector<std::optional<std::size_t>> rows;
  std::vector<std::string> lacking;
  for (const std::string& name : cases)
  {
    rows.push_back(RowOf(name, table, column, file));
    if (!rows.back())
    {
      lacking.push_back(name);
    }
  }
  if (lacking.size() == cases.size())
  {
    throw InputError(file.string() + ": no " + table.Columns[column] + " (such as " +
                     table.Rows[0][column] + ") is the name of a case (such as " +
                     (cases.empty() ? "" : cases[0]) +
                     ") or a part of it; name the column by --id");
  }
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
