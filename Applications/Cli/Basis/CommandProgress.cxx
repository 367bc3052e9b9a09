#include "CommandProgress.h"

#include "Console.h"
#include "Interruption.h"

#include <filesystem>

namespace palpate::cli
{
ProgressFunction ProgressOn(Console& console)
{
  return [&console](double fraction, const std::string& stage)
  {
    console.Progress(fraction, stage);
    return !Interruption::WasAsked();
  };
}

std::string CountedCase(std::size_t number, std::size_t count, const std::string& title)
{
  return count > 1
             ? "case " + std::to_string(number) + " of " + std::to_string(count) + ": " + title
             : title;
}

std::string OfFile(std::size_t number, const std::vector<std::string>& files,
                   const std::string& title)
{
  return files.size() > 1
             ? "file " + std::to_string(number) + " of " + std::to_string(files.size()) + ": " +
                   std::filesystem::path(files[number - 1]).filename().string() + ", " + title
             : title;
}
} // namespace palpate::cli
