#include "CasePattern.h"

#include "ImageFormat.h"
#include "InputError.h"
#include "SurfaceFile.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

namespace palpate
{
namespace
{
constexpr std::string_view IdMark = "{id}";
constexpr std::size_t LongestPattern = 4096;

// Greedy, so that time grows with the product of the lengths at most.
bool MatchesStars(std::string_view text, std::string_view pattern)
{
  std::size_t t = 0;
  std::size_t p = 0;
  std::size_t star = std::string_view::npos;
  std::size_t resumed = 0;
  while (t < text.size())
  {
    if (p < pattern.size() && pattern[p] == '*')
    {
      star = p++;
      resumed = t;
    }
    else if (p < pattern.size() && pattern[p] == text[t])
    {
      ++p;
      ++t;
    }
    else if (star != std::string_view::npos)
    {
      p = star + 1;
      t = ++resumed;
    }
    else
    {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::string WithId(std::string text, const std::string& id)
{
  for (std::size_t at = text.find(IdMark); at != std::string::npos;
       at = text.find(IdMark, at + id.size()))
  {
    text.replace(at, IdMark.size(), id);
  }
  return text;
}

/// The shortest id with which a name matches a pattern that has one or more places for it.
std::optional<std::string> IdIn(const std::string& name, const std::string& pattern)
{
  const std::string before = pattern.substr(0, pattern.find(IdMark));
  std::vector<std::size_t> starts;
  for (std::size_t first = 0; first < name.size(); ++first)
  {
    if (MatchesStars(std::string_view(name).substr(0, first), before))
    {
      starts.push_back(first);
    }
  }
  for (std::size_t length = 1; length <= name.size(); ++length)
  {
    for (const std::size_t first : starts)
    {
      const std::string id = name.substr(first, length);
      // Marks in an id would be taken for those of the pattern.
      const bool hasMark = id.find('*') != std::string::npos || IsCasePattern(id);
      if (!hasMark && MatchesStars(name, WithId(pattern, id)))
      {
        return id;
      }
    }
  }
  return std::nullopt;
}

void CheckPattern(const std::string& pattern)
{
  const auto has = [&](const char* part) { return pattern.find(part) != std::string::npos; };
  if (pattern.size() > LongestPattern)
  {
    throw InputError("a pattern of cases has at most " + std::to_string(LongestPattern) +
                     " characters");
  }
  if (has("{id}*") || has("*{id}") || has("{id}{id}"))
  {
    throw InputError(pattern + ": {id} must have a character before and after it that separates it "
                               "from * or another {id}, such as sub-{id}_*.nii.gz");
  }
}

/// A path whose first components matched, with the id that they had.
struct PartMatch
{
  std::filesystem::path Path;
  std::optional<std::string> Id;
};

// Without a place for an id or a star a component is taken as it is.
std::vector<PartMatch> MatchesIn(const PartMatch& folder, const std::string& component)
{
  const std::string known = folder.Id ? WithId(component, *folder.Id) : component;
  const bool seeksId = known.find(IdMark) != std::string::npos;
  std::error_code error;
  if (!seeksId && component.find('*') == std::string::npos)
  {
    const PartMatch next{folder.Path / known, folder.Id};
    return std::filesystem::exists(next.Path, error) ? std::vector{next} : std::vector<PartMatch>{};
  }
  std::vector<PartMatch> matches;
  const std::filesystem::path listed = folder.Path.empty() ? "." : folder.Path;
  for (std::filesystem::directory_iterator entry(listed, error), end; !error && entry != end;
       entry.increment(error))
  {
    const std::string name = entry->path().filename().string();
    if (name.front() == '.' && component.front() != '.')
    {
      continue;
    }
    const std::optional<std::string> id = seeksId ? IdIn(name, known) : folder.Id;
    if (seeksId ? id.has_value() : MatchesStars(name, known))
    {
      matches.push_back({folder.Path / name, id});
    }
  }
  if (error && std::filesystem::is_directory(listed))
  {
    throw InputError(listed.string() + " cannot be listed: " + error.message());
  }
  return matches;
}

bool IsReadable(const std::filesystem::path& file)
{
  std::error_code ignored;
  return (!EndingOf(file, ReadableImageEndings()).empty() ||
          !EndingOf(file, SurfaceFormats().ReadEndings()).empty()) &&
         std::filesystem::is_regular_file(file, ignored);
}
} // namespace

bool IsCasePattern(const std::string& text)
{
  return text.find(IdMark) != std::string::npos;
}

std::vector<CohortCase> FindPatternCases(const std::string& pattern)
{
  CheckPattern(pattern);
  const std::filesystem::path whole(pattern);
  std::vector<PartMatch> found{{whole.root_path(), std::nullopt}};
  for (const std::filesystem::path& component : whole.relative_path())
  {
    std::vector<PartMatch> next;
    for (const PartMatch& folder : found)
    {
      const std::vector<PartMatch> matches = MatchesIn(folder, component.string());
      next.insert(next.end(), matches.begin(), matches.end());
    }
    found = std::move(next);
  }
  std::vector<CohortCase> cases;
  for (const PartMatch& match : found)
  {
    if (match.Id && IsReadable(match.Path))
    {
      cases.push_back({*match.Id, match.Path, {}, {}});
    }
  }
  if (cases.empty())
  {
    throw InputError(pattern + " matches no readable segmentation or surface");
  }
  std::sort(cases.begin(), cases.end(),
            [](const CohortCase& a, const CohortCase& b)
            { return a.Name != b.Name ? a.Name < b.Name : a.Mask < b.Mask; });
  for (std::size_t i = 1; i < cases.size(); ++i)
  {
    if (cases[i].Name == cases[i - 1].Name)
    {
      throw InputError(pattern + ": id " + cases[i].Name + " has several files, such as " +
                       cases[i - 1].Mask.string() + " and " + cases[i].Mask.string() +
                       "; make the pattern match one");
    }
  }
  CheckCaseNames(pattern, cases);
  return cases;
}
} // namespace palpate
