#include "LabelTable.h"

#include "InputError.h"
#include "JsonText.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

namespace palpate
{
namespace
{
using Color = std::array<double, 3>;
constexpr double Full = 255.0;

std::string Bare(const std::string& text)
{
  constexpr const char* Blank = " \t\r\"";
  const auto first = text.find_first_not_of(Blank);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(Blank) - first + 1);
}

std::optional<int> NumberIn(const std::string& text)
{
  constexpr std::size_t Longest = 9; // digits of an int
  const bool isNumber =
      !text.empty() && text.size() <= Longest &&
      std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  return isNumber ? std::optional(std::stoi(text)) : std::nullopt;
}

std::optional<Color> ColorIn(const std::vector<std::string>& words, std::size_t first)
{
  Color color{};
  for (std::size_t channel = 0; channel < 3; ++channel)
  {
    const std::size_t place = first + channel;
    const auto value = place < words.size() ? NumberIn(words[place]) : std::nullopt;
    if (!value || *value > Full)
    {
      return std::nullopt;
    }
    color[channel] = *value / Full;
  }
  return color;
}

std::optional<Color> HexColorIn(const std::string& text)
{
  constexpr int Hexadecimal = 16;
  constexpr unsigned long Byte = 256;
  if (text.size() != 7 || text[0] != '#' ||
      !std::all_of(text.begin() + 1, text.end(),
                   [](unsigned char c) { return std::isxdigit(c) != 0; }))
  {
    return std::nullopt;
  }
  const unsigned long value = std::stoul(text.substr(1), nullptr, Hexadecimal);
  return Color{static_cast<double>(value / (Byte * Byte)) / Full,
               static_cast<double>(value / Byte % Byte) / Full,
               static_cast<double>(value % Byte) / Full};
}

// An index, then seven fields and a name in quotes (ITK-SNAP), or a name, then perhaps a colour.
bool TakeLine(const std::string& line, LabelTable& table)
{
  const auto quote = line.find('"');
  std::istringstream stream(line.substr(0, quote));
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  const auto index = words.empty() ? std::nullopt : NumberIn(words[0]);
  if (!index)
  {
    return false;
  }
  if (quote != std::string::npos)
  {
    table[*index] = {Bare(line.substr(quote)), ColorIn(words, 1)};
    return true;
  }
  // A table of numbers has no names.
  if (words.size() < 2 ||
      std::none_of(words[1].begin(), words[1].end(),
                   [](unsigned char c) { return std::isalpha(c) != 0 || c >= 0x80; }))
  {
    return false;
  }
  constexpr std::size_t WithColor = 5; // index, name and three channels
  table[*index] = {words[1], words.size() >= WithColor ? ColorIn(words, 2) : std::nullopt};
  return true;
}

std::vector<std::string> FieldsOf(const std::string& line, char separator)
{
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, separator);)
  {
    fields.push_back(Bare(field));
  }
  return fields;
}

// The first column of one of these names, whatever its case.
std::optional<std::size_t> ColumnOf(const std::vector<std::string>& head,
                                    std::initializer_list<const char*> names)
{
  for (const char* name : names)
  {
    for (std::size_t column = 0; column < head.size(); ++column)
    {
      std::string lower = head[column];
      std::transform(lower.begin(), lower.end(), lower.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      if (lower == name)
      {
        return column;
      }
    }
  }
  return std::nullopt;
}

std::optional<LabelTable> UnlessEmpty(LabelTable table)
{
  return table.empty() ? std::nullopt : std::optional(std::move(table));
}
} // namespace

std::optional<LabelTable> LabelLines(const std::string& text)
{
  LabelTable table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    const auto first = line.find_first_not_of(" \t\r");
    const bool isBlank = first == std::string::npos || line[first] == '#';
    if (!isBlank && !TakeLine(line, table))
    {
      return std::nullopt;
    }
  }
  return UnlessEmpty(std::move(table));
}

std::string ItkSnapTextOf(const LabelTable& table)
{
  std::string text = "# ITK-SnAP Label Description File\n# index, red, green, blue, opacity, "
                     "visibility, mesh visibility, name\n0 0 0 0 0 0 0 \"Clear Label\"\n";
  for (const auto& [value, entry] : table)
  {
    text += std::to_string(value);
    for (const double channel : entry.Color.value_or(Color{1.0, 1.0, 1.0}))
    {
      text += " " + std::to_string(std::lround(channel * Full));
    }
    std::string name = entry.Name.empty() ? "label " + std::to_string(value) : entry.Name;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == '"'; }, '\'');
    text += " 1 1 1 \"" + name + "\"\n";
  }
  return text;
}

std::optional<LabelTable> LabelColumns(const std::string& text)
{
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const char separator = line.find('\t') != std::string::npos ? '\t' : ',';
  const std::vector<std::string> head = FieldsOf(line, separator);
  const auto index = ColumnOf(head, {"index", "label", "value", "id", "key", "labelvalue"});
  const auto name = ColumnOf(head, {"name", "structure", "region", "label_name"});
  const auto color = ColumnOf(head, {"color", "colour"});
  const auto red = ColumnOf(head, {"r", "red"});
  if (!index || !name)
  {
    return std::nullopt;
  }
  LabelTable table;
  while (std::getline(lines, line))
  {
    const std::vector<std::string> fields = FieldsOf(line, separator);
    if (fields.empty() || (fields.size() == 1 && fields[0].empty()))
    {
      continue;
    }
    const auto value = *index < fields.size() ? NumberIn(fields[*index]) : std::nullopt;
    if (!value || *name >= fields.size())
    {
      return std::nullopt;
    }
    LabelEntry& entry = table[*value];
    entry.Name = fields[*name];
    entry.Color = color && *color < fields.size() ? HexColorIn(fields[*color])
                  : red                           ? ColorIn(fields, *red)
                                                  : std::nullopt;
  }
  return UnlessEmpty(std::move(table));
}

std::optional<LabelTable> LabelsOfDataset(const std::string& json)
{
  nlohmann::json document;
  try
  {
    document = ParseJson(json, "dataset.json", "");
  }
  catch (const InputError&)
  {
    return std::nullopt;
  }
  if (!document.is_object() || !document.contains("labels") || !document["labels"].is_object())
  {
    return std::nullopt;
  }
  LabelTable table;
  for (const auto& [key, value] : document["labels"].items())
  {
    if (value.is_string())
    {
      if (const auto index = NumberIn(key))
      {
        table[*index].Name = value.get<std::string>();
      }
    }
    else if (value.is_number_unsigned() && value.get<std::uint64_t>() <= 0x7fffffff)
    {
      table[value.get<int>()].Name = key;
    }
  }
  return UnlessEmpty(std::move(table));
}
} // namespace palpate
