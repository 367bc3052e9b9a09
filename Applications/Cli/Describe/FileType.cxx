#include "FileType.h"

#include <iterator>
#include <sstream>
#include <utility>

namespace palpate::cli
{
namespace
{
// CLI11 keeps copies of its base class only, so the declaration is in the validator's name.
constexpr const char* FileMark = "file";
} // namespace

FileType FileType::Input(const std::string& content, const std::string& ending)
{
  return FileType(FileMark + (" input " + content) + " " + ending);
}

FileType FileType::Output(const std::string& content, const std::string& ending)
{
  return FileType(FileMark + (" output " + content) + " " + ending);
}

FileType FileType::OutputFolder(const std::vector<std::string>& names)
{
  std::string words = FileMark + std::string(" output directory");
  for (const std::string& name : names)
  {
    words += " " + name;
  }
  return FileType(words);
}

std::optional<FileType::Declared> FileType::Of(const CLI::Option& option)
{
  // CLI11 lists validators, until one is missing, for options that may change only.
  auto& listed = const_cast<CLI::Option&>(option);
  try
  {
    for (int index = 0;; ++index)
    {
      std::istringstream name(listed.get_validator(index)->get_name());
      std::string mark;
      std::string channel;
      Declared declared{};
      if (name >> mark >> channel >> declared.Content && mark == FileMark)
      {
        declared.IsOutput = channel == "output";
        std::vector<std::string> words{std::istream_iterator<std::string>(name), {}};
        if (declared.Content == "directory")
        {
          declared.Names = std::move(words);
        }
        else if (!words.empty())
        {
          declared.Ending = words.front();
        }
        return declared;
      }
    }
  }
  catch (const CLI::OptionNotFound&)
  {
    return std::nullopt;
  }
}
} // namespace palpate::cli
