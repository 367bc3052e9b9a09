#include "CsvText.h"

#include "CsvCell.h"

namespace palpate
{
namespace
{
constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";

class CsvReader
{
public:
  std::vector<std::vector<std::string>> Read(std::string_view text)
  {
    for (std::size_t i = 0; i < text.size(); ++i)
    {
      const bool isDoubled = this->Quoted && text[i] == '"' && text.substr(i + 1, 1) == "\"";
      i += isDoubled ? 1 : 0;
      this->Take(text[i], isDoubled);
    }
    this->EndRow();
    return std::move(this->Rows);
  }

private:
  void Take(char letter, bool isDoubled)
  {
    if (letter == '"' && !isDoubled)
    {
      this->Quoted = !this->Quoted;
    }
    else if (!this->Quoted && letter == ',')
    {
      this->EndField();
    }
    else if (!this->Quoted && letter == '\n')
    {
      this->EndRow();
    }
    else if (this->Quoted || letter != '\r')
    {
      this->Field += letter;
    }
  }
  void EndField()
  {
    this->Row.push_back(TextOfCell(this->Field));
    this->Field.clear();
  }
  void EndRow()
  {
    this->EndField();
    if (this->Row.size() > 1 || !this->Row.front().empty())
    {
      this->Rows.push_back(std::move(this->Row));
    }
    this->Row.clear();
  }

  std::vector<std::vector<std::string>> Rows;
  std::vector<std::string> Row;
  std::string Field;
  bool Quoted = false;
};
} // namespace

std::vector<std::vector<std::string>> ParseCsv(std::string_view text)
{
  const bool isMarked = text.substr(0, ByteOrderMark.size()) == ByteOrderMark;
  return CsvReader().Read(text.substr(isMarked ? ByteOrderMark.size() : 0));
}

std::string CsvLine(const std::vector<std::string>& fields)
{
  std::string line;
  for (const std::string& text : fields)
  {
    const std::string field = InertCell(text);
    line += &text == &fields.front() ? "" : ",";
    if (field.find_first_of(",;\t\"\r\n") == std::string::npos)
    {
      line += field;
      continue;
    }
    line += '"';
    for (const char letter : field)
    {
      line.append(letter == '"' ? 2 : 1, letter);
    }
    line += '"';
  }
  return line + "\n";
}

std::vector<CsvRecord> ParseCsvRecords(std::string_view text)
{
  const auto rows = ParseCsv(text);
  std::vector<CsvRecord> records;
  for (std::size_t r = 1; r < rows.size(); ++r)
  {
    CsvRecord record;
    for (std::size_t column = 0; column < rows.front().size(); ++column)
    {
      record[rows.front()[column]] = column < rows[r].size() ? rows[r][column] : std::string();
    }
    records.push_back(std::move(record));
  }
  return records;
}
} // namespace palpate
