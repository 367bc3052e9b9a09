#include "CaseNames.h"

#include "FitStructure.h"
#include "OutputNames.h"

#include <algorithm>
#include <map>

namespace palpate
{
namespace
{
// Absolute, so that `.` and `folder/` have a name too.
std::filesystem::path WholePath(const std::string& input)
{
  const std::filesystem::path whole = std::filesystem::absolute(input).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

std::string Unique(const std::string& name, std::set<std::string>& taken)
{
  std::string unique = name;
  for (int number = 2; !taken.insert(FoldedName(unique)).second; ++number)
  {
    const std::string end = "-" + std::to_string(number);
    unique = name.substr(0, std::max(name.size(), LongestPlainName) - end.size()) + end;
  }
  return unique;
}
} // namespace

CaseNames::CaseNames(const std::vector<std::string>& inputs)
{
  std::map<std::string, int> counts;
  for (const std::string& input : inputs)
  {
    this->Inputs.push_back(PlainName(CaseNameOf(WholePath(input))));
    ++counts[FoldedName(this->Inputs.back())];
  }
  std::set<std::string> taken;
  for (const auto& [name, count] : counts)
  {
    // A name that several would share is ambiguous, so none gets it.
    taken.insert(name);
  }
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    std::string& name = this->Inputs[i];
    if (counts[FoldedName(name)] > 1)
    {
      std::string withFolder = WholePath(inputs[i]).parent_path().filename().string();
      withFolder.append("_").append(name);
      name = Unique(PlainName(withFolder), taken);
    }
  }
}

std::string CaseNames::Take(std::size_t input, const Segment& structure)
{
  return Unique(CaseFolderName(this->Inputs[input], structure), this->Taken);
}
} // namespace palpate
