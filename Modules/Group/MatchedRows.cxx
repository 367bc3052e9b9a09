#include "MatchedRows.h"

#include "DecimalText.h"
#include "FitStructure.h"
#include "InputError.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace palpate
{
namespace
{
// participant_id of BIDS has it, a pattern such as sub-{id} leaves it out.
const std::string BidsPrefix = "sub-";
constexpr std::size_t MostDigits = 15; // every such number is a double

bool IsPartOfWord(const std::string& name, std::size_t place)
{
  return place < name.size() && std::isalnum(static_cast<unsigned char>(name[place])) != 0;
}

bool HasWholePart(const std::string& name, const std::string& part)
{
  for (std::size_t at = name.find(part); at != std::string::npos; at = name.find(part, at + 1))
  {
    if ((at == 0 || !IsPartOfWord(name, at - 1)) && !IsPartOfWord(name, at + part.size()))
    {
      return true;
    }
  }
  return false;
}

// The first whole part that is digits only; empty if there is none.
std::string FirstNumberOf(const std::string& name)
{
  for (std::size_t first = 0; first < name.size();)
  {
    std::size_t end = first;
    while (IsPartOfWord(name, end))
    {
      ++end;
    }
    const std::string part = name.substr(first, end - first);
    if (!part.empty() && part.find_first_not_of("0123456789") == std::string::npos)
    {
      return part;
    }
    first = end + 1;
  }
  return {};
}

// "001", "1" and "1.0" give "1"; nothing for what is no whole number from 0 on.
std::string WholeNumber(const std::string& text)
{
  const auto number = ParseNumber(text);
  const bool isWhole = number && *number >= 0.0 && std::floor(*number) == *number;
  return isWhole && text.size() <= MostDigits ? std::to_string(static_cast<long long>(*number))
                                              : std::string();
}
} // namespace

MatchedRows::MatchedRows(std::vector<std::string> ids, const std::vector<std::string>& cases,
                         std::string source, std::string column)
    : Ids(std::move(ids)), Source(std::move(source)), Column(std::move(column))
{
  for (const std::string& name : cases)
  {
    this->Found.push_back(this->RowOf(name, this->Ids));
  }
  this->AddFiles(cases);
  this->AddNumbers(cases);
}

std::optional<std::size_t> MatchedRows::RowOf(const std::string& name,
                                              const std::vector<std::string>& ids) const
{
  std::optional<std::size_t> best;
  bool isUnique = true;
  for (std::size_t row = 0; row < ids.size(); ++row)
  {
    const std::string& id = ids[row];
    if (id.empty() || !(HasWholePart(name, id) || id == BidsPrefix + name))
    {
      continue;
    }
    const std::size_t known = best ? ids[*best].size() : 0;
    if (id.size() >= known)
    {
      isUnique = id.size() > known;
      best = row;
    }
  }
  if (!isUnique)
  {
    throw InputError(this->Source + ": several rows have the " + this->Column + " " + ids[*best] +
                     " of case " + name + "; name a column with one value per case by --id");
  }
  return best;
}

void MatchedRows::AddFiles(const std::vector<std::string>& cases)
{
  std::vector<std::string> names;
  for (const std::string& id : this->Ids)
  {
    const std::string file = id.substr(id.find_last_of("/\\") + 1);
    const std::string name = CaseNameOf(file);
    names.push_back(name == id ? std::string() : name);
  }
  std::size_t count = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    if (!this->Found[i] && (this->Found[i] = this->RowOf(cases[i], names)))
    {
      ++count;
      last = i;
    }
  }
  if (count > 0)
  {
    this->AddNote(count, this->Ids[*this->Found[last]], cases[last]);
  }
}

void MatchedRows::AddNumbers(const std::vector<std::string>& cases)
{
  std::map<std::string, std::vector<std::size_t>> rows;
  for (std::size_t row = 0; row < this->Ids.size(); ++row)
  {
    rows[WholeNumber(this->Ids[row])].push_back(row);
  }
  std::map<std::string, std::set<std::string>> spellings;
  for (const std::string& name : cases)
  {
    const std::string digits = FirstNumberOf(name);
    spellings[WholeNumber(digits)].insert(digits);
  }
  std::size_t count = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const std::string number = WholeNumber(FirstNumberOf(cases[i]));
    const auto found = rows.find(number);
    const bool isUnambiguous = !number.empty() && found != rows.end() &&
                               found->second.size() == 1 && spellings[number].size() == 1;
    if (!this->Found[i] && isUnambiguous)
    {
      this->Found[i] = found->second.front();
      ++count;
      last = i;
    }
  }
  if (count > 0)
  {
    this->AddNote(count, this->Ids[*this->Found[last]], cases[last]);
  }
}

void MatchedRows::AddNote(std::size_t count, const std::string& id, const std::string& name)
{
  this->Remarks.push_back(
      this->Source + ": " + std::to_string(count) + (count == 1 ? " case was" : " cases were") +
      " found by an id that is written differently: " + id + " is taken for " + name);
}
} // namespace palpate
