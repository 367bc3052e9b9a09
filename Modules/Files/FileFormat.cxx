#include "FileFormat.h"

#include <cctype>

namespace palpate
{
std::string EndingOf(const std::filesystem::path& file, const std::vector<std::string>& endings)
{
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::string found;
  for (const std::string& ending : endings)
  {
    const bool has = name.size() > ending.size() &&
                     name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
    found = has && ending.size() > found.size() ? ending : found;
  }
  return found;
}

std::string ListOfEndings(const std::vector<std::string>& endings)
{
  std::string list;
  for (std::size_t i = 0; i < endings.size(); ++i)
  {
    list += i == 0 ? "" : i + 1 == endings.size() ? " or " : ", ";
    list += endings[i];
  }
  return list;
}

std::string PatternsOf(const std::vector<std::string>& endings)
{
  std::string patterns;
  for (const std::string& ending : endings)
  {
    patterns += (patterns.empty() ? "*" : " *") + ending;
  }
  return patterns;
}
} // namespace palpate
