#include "OutputNames.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
constexpr std::size_t LongestFolderName = 80;

// Endings of files that commands write next to the folders of cases.
constexpr std::array<const char*, 4> OutputEndings{{".csv", ".html", ".json", ".vtp"}};

// Independent of the locale, unlike std::isalnum.
bool IsPlain(char letter)
{
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '-' || letter == '_' || letter == '.';
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// "Naming Files, Paths, and Namespaces", learn.microsoft.com: with any ending, in any case.
bool IsWindowsDevice(const std::string& name)
{
  const std::string stem = FoldedName(name.substr(0, name.find('.')));
  const bool isNumbered = stem.size() == 4 && stem[3] >= '0' && stem[3] <= '9';
  const std::string word = isNumbered ? stem.substr(0, 3) : stem;
  return isNumbered ? word == "com" || word == "lpt"
                    : word == "con" || word == "prn" || word == "aux" || word == "nul";
}

// Each byte of a non-ASCII character becomes one underscore.
std::string Sanitised(std::string text, std::size_t longest)
{
  std::replace_if(
      text.begin(), text.end(), [](char letter) { return !IsPlain(letter); }, '_');
  text = (text.empty() || IsWindowsDevice(text) ? "_" + text : text).substr(0, longest);
  for (std::size_t i = 0; i < text.size() && text[i] == '.'; ++i)
  {
    text[i] = '_';
  }
  for (std::size_t i = text.size(); i > 0 && text[i - 1] == '.'; --i)
  {
    text[i - 1] = '_';
  }
  const std::string folded = FoldedName(text);
  if (std::any_of(OutputEndings.begin(), OutputEndings.end(),
                  [&](const char* ending) { return EndsWith(folded, ending); }))
  {
    text[text.rfind('.')] = '_';
  }
  return text;
}
} // namespace

std::string PlainName(const std::string& text)
{
  return Sanitised(text, LongestPlainName);
}

std::string FoldedName(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char letter)
                 {
                   const bool isCapital = letter >= 'A' && letter <= 'Z';
                   return isCapital ? static_cast<char>(letter - 'A' + 'a') : letter;
                 });
  return name;
}

std::string CaseFolderName(const std::string& caseName, const Segment& structure)
{
  if (structure.Label == 0) // a surface
  {
    return Sanitised(PlainName(caseName), LongestFolderName);
  }
  const std::string name = PlainName(caseName) + "_" + std::to_string(structure.Label);
  return Sanitised(structure.Name.empty() ? name : name + "_" + structure.Name, LongestFolderName);
}

std::string StructureFolderName(const Segment& structure)
{
  const std::string label = std::to_string(structure.Label);
  return structure.Name.empty() ? label : label + "_" + PlainName(structure.Name);
}
} // namespace palpate
