#include "DeclaredOption.h"

#include "DecimalText.h"

#include <algorithm>
#include <sstream>

namespace palpate::cli
{
namespace
{
// CLI11 exposes an IsMember check's values only within the option's type name: "TEXT:{a,b}".
std::vector<std::string> FixedValues(const std::string& typeName)
{
  std::vector<std::string> values;
  const std::size_t open = typeName.find('{');
  const std::size_t close = typeName.find('}', open);
  if (open != std::string::npos && close != std::string::npos)
  {
    std::istringstream list(typeName.substr(open + 1, close - open - 1));
    for (std::string value; std::getline(list, value, ',');)
    {
      values.push_back(value);
    }
  }
  return values;
}

// Likewise a range: "INT in [0 - 100]" of CLI::Range, "from 0 to 10" of FiniteNumber.
std::optional<std::array<double, 2>> RangeIn(const std::string& check)
{
  std::istringstream words(
      check.substr(std::min(check.size(), check.find_first_of("0123456789-"))));
  std::string low;
  std::string separator;
  std::string high;
  words >> low >> separator >> high;
  high.resize(std::min(high.size(), high.find(']')));
  const auto first = ParseNumber(low);
  const auto last = ParseNumber(high);
  return first && last && (separator == "-" || separator == "to")
             ? std::optional(std::array{*first, *last})
             : std::nullopt;
}

bool StartsWithOneOf(const std::string& text, const std::vector<std::string>& starts)
{
  return std::any_of(starts.begin(), starts.end(),
                     [&text](const std::string& start) { return text.rfind(start, 0) == 0; });
}
} // namespace

DeclaredOption::DeclaredOption(const CLI::Option& option)
    : Place(option.get_name(true, false)), Help(option.get_description()),
      File(FileType::Of(option)), Default(option.get_default_str()),
      IsRequired(option.get_required()), IsList(option.get_items_expected_max() > 1),
      IsCommaSeparated(option.get_delimiter() == ',')
{
  for (const std::string& name : option.get_snames())
  {
    this->Names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames())
  {
    this->Names.push_back("--" + name);
  }
  const std::string typeName = option.get_type_name();
  const std::size_t colon = std::min(typeName.size(), typeName.find(':'));
  const std::string check = colon < typeName.size() ? typeName.substr(colon + 1) : "";
  this->Word = typeName.substr(0, colon);
  this->Values = FixedValues(typeName);
  this->Range = RangeIn(check);
  // Not a number with its own separator, such as 800x600.
  const bool isPlain = !this->IsList || this->IsCommaSeparated || option.get_delimiter() == '\0';
  this->Type = option.get_items_expected_max() == 0 ? Kind::Flag
               : this->File                         ? Kind::File
               : !this->Values.empty()              ? Kind::Choice
               : isPlain && (StartsWithOneOf(check, {"INT", "UINT"}) ||
                             StartsWithOneOf(this->Word, {"INT", "UINT"}))
                   ? Kind::Integer
               : isPlain && (StartsWithOneOf(check, {"from ", "above ", "that is finite"}) ||
                             this->Word == "FLOAT")
                   ? Kind::Real
                   : Kind::Text;
}

bool DeclaredOption::HasName(const std::string& name) const
{
  return std::find(this->Names.begin(), this->Names.end(), name) != this->Names.end();
}
} // namespace palpate::cli
