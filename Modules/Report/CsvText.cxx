#include "CsvText.h"

#include "CsvCell.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";

std::string_view WithoutMark(std::string_view text)
{
  const bool isMarked = text.substr(0, ByteOrderMark.size()) == ByteOrderMark;
  return text.substr(isMarked ? ByteOrderMark.size() : 0);
}

// Excel's "sep=;" says what separates the fields.
bool NamesSeparator(std::string_view text)
{
  return text.substr(0, 4) == "sep=" && text.size() > 5 && (text[5] == '\r' || text[5] == '\n');
}

class CsvReader
{
public:
  using TakeRow = std::function<void(std::vector<std::string>)>;
  CsvReader(char separator, TakeRow take) : Separator(separator), Give(std::move(take)) {}

  void Read(std::string_view text)
  {
    for (std::size_t i = 0; i < text.size(); ++i)
    {
      const bool isDoubled = this->Quoted && text[i] == '"' && text.substr(i + 1, 1) == "\"";
      i += isDoubled ? 1 : 0;
      const bool isLineEnd = !this->Quoted && text[i] == '\r';
      i += isLineEnd && text.substr(i + 1, 1) == "\n" ? 1 : 0;
      this->Take(isLineEnd ? '\n' : text[i], isDoubled);
    }
    this->EndRow();
  }

private:
  void Take(char letter, bool isDoubled)
  {
    // Within a field that has none at its start, a quote is a letter.
    if (letter == '"' && !isDoubled && (this->Quoted || this->Field.empty()))
    {
      this->Quoted = !this->Quoted;
    }
    else if (!this->Quoted && letter == this->Separator)
    {
      this->EndField();
    }
    else if (!this->Quoted && letter == '\n')
    {
      this->EndRow();
    }
    else
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
      this->Give(std::move(this->Row));
    }
    this->Row.clear();
  }

  char Separator;
  TakeRow Give;
  std::vector<std::string> Row;
  std::string Field;
  bool Quoted = false;
};
} // namespace

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

const std::string* CsvRecord::Find(const std::string& column) const
{
  static const std::string Empty;
  const auto found = this->Head->find(column);
  if (found == this->Head->end())
  {
    return nullptr;
  }
  return found->second < this->Fields.size() ? &this->Fields[found->second] : &Empty;
}

std::vector<std::string> CsvRecord::Columns() const
{
  std::map<std::size_t, std::string> ordered;
  for (const auto& [name, place] : *this->Head)
  {
    ordered[place] = name;
  }
  std::vector<std::string> names;
  for (auto& [place, name] : ordered)
  {
    names.push_back(name);
  }
  return names;
}

char CsvSeparator(std::string_view text)
{
  constexpr std::string_view Separators = ",;\t";
  std::array<std::size_t, Separators.size()> counts{};
  bool isQuoted = false;
  text = WithoutMark(text);
  if (NamesSeparator(text))
  {
    return text[4];
  }
  const auto isLineEnd = [](char letter) { return letter == '\n' || letter == '\r'; };
  for (std::size_t i = 0; i < text.size() && (isQuoted || !isLineEnd(text[i])); ++i)
  {
    isQuoted = isQuoted != (text[i] == '"');
    const std::size_t kind = Separators.find(text[i]);
    if (!isQuoted && kind != std::string_view::npos)
    {
      ++counts.at(kind);
    }
  }
  return Separators[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) -
                                             counts.begin())];
}

void ForEachCsvRecord(std::string_view text, const std::function<void(const CsvRecord&)>& take)
{
  std::shared_ptr<const CsvRecord::Places> head;
  const auto takeRow = [&](std::vector<std::string> row)
  {
    if (head)
    {
      return take(CsvRecord(head, std::move(row)));
    }
    auto columns = std::make_shared<CsvRecord::Places>();
    for (std::size_t column = 0; column < row.size(); ++column)
    {
      (*columns)[row[column]] = column;
    }
    head = std::move(columns);
  };
  const char separator = CsvSeparator(text);
  text = WithoutMark(text);
  text.remove_prefix(NamesSeparator(text) ? 5 : 0);
  CsvReader(separator, takeRow).Read(text);
}
} // namespace palpate
