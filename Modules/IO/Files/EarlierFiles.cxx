#include "EarlierFiles.h"

#include "Refusal.h"

#include <algorithm>
#include <fstream>

namespace palpate
{
namespace
{
// Of the pages of 0.1.0, which have no PageGenerator.
constexpr const char* OlderPage = "--paper: #ffffff; --panel: #f6f7f9; --ink: #1c2127;";

// Empty for what is no file that can be read, and for a link, which is replaced itself.
std::string HeadOf(const std::filesystem::path& file)
{
  constexpr std::size_t HeadBytes = 4096;
  std::error_code ignored;
  std::string head(HeadBytes, '\0');
  std::ifstream stream;
  if (std::filesystem::is_regular_file(std::filesystem::symlink_status(file, ignored)))
  {
    stream.open(file, std::ios::binary);
    stream.read(head.data(), HeadBytes);
  }
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head;
}

bool HasOneOf(const std::string& head, const std::vector<const char*>& marks)
{
  return std::any_of(marks.begin(), marks.end(),
                     [&head](const char* mark) { return head.find(mark) != std::string::npos; });
}

bool IsPage(const std::string& name)
{
  return std::filesystem::path(name).extension() == ".html";
}

bool IsOurs(const std::string& name, const std::string& head)
{
  return IsPage(name) ? HasOneOf(head, {PageGenerator, OlderPage})
                      : head.rfind("palpate-", 0) == 0 ||
                            HasOneOf(head, {"\"palpate-", "palpate spherical-harmonic model"});
}

// Whether files of this kind say that they are ours.
bool IsMarked(const std::string& name)
{
  const std::filesystem::path ending = std::filesystem::path(name).extension();
  return IsPage(name) || ending == ".json" || ending == ".touch";
}
} // namespace

void RequireEarlierFiles(const std::filesystem::path& folder, const std::vector<std::string>& names)
{
  std::string foreign;
  bool isVouchedFor = false;
  for (const std::string& name : names)
  {
    const std::string head = HeadOf(folder / name);
    const bool isOurs = IsOurs(name, head);
    isVouchedFor = isVouchedFor || isOurs;
    if (IsMarked(name) && !head.empty() && !isOurs && (foreign.empty() || IsPage(name)))
    {
      foreign = name;
    }
  }
  if (!foreign.empty() && (IsPage(foreign) || !isVouchedFor))
  {
    Refuse(folder / foreign, "would be replaced, but is not recognised as written by Palpate",
           "choose another output folder, or move or delete that file");
  }
}

void RequireOtherFile(const std::filesystem::path& output, const std::filesystem::path& input)
{
  std::error_code missing;
  if (std::filesystem::equivalent(output, input, missing) &&
      !std::filesystem::is_directory(output, missing))
  {
    Refuse(output, "is an input of this command, which would be replaced", "choose another output");
  }
}
} // namespace palpate
