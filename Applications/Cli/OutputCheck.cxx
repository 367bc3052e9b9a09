#include "OutputCheck.h"

#include "EarlierFiles.h"
#include "FileType.h"
#include "MaskFolders.h"

#include <CLI/CLI.hpp>

namespace palpate::cli
{
namespace
{
void CheckOutput(const std::filesystem::path& output, const FileType::Declared& type,
                 const std::vector<std::string>& inputs)
{
  std::vector<std::filesystem::path> files;
  for (const std::string& name : type.Names)
  {
    files.push_back(output / name);
  }
  if (files.empty())
  {
    files.push_back(output);
  }
  for (const std::filesystem::path& file : files)
  {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
    {
      continue; // not compared with each of thousands of masks
    }
    for (const std::string& input : inputs)
    {
      RequireOtherFile(file, input);
    }
  }
  RequireEarlierFiles(output, type.Names);
}
} // namespace

void CheckOutputs(const CLI::App& command)
{
  std::vector<std::string> inputs;
  std::vector<std::pair<std::string, FileType::Declared>> outputs;
  std::vector<std::pair<std::string, FileType::Declared>> defaults;
  for (const CLI::Option* option : command.get_options())
  {
    const std::optional<FileType::Declared> type = FileType::Of(*option);
    for (const std::string& word : type ? option->results() : std::vector<std::string>())
    {
      if (type->IsOutput)
      {
        // A positional folder holds inputs, and is written only if no other is named.
        (option->get_positional() && type->Content == "directory" ? defaults : outputs)
            .emplace_back(word, *type);
      }
      else
      {
        inputs.push_back(word);
      }
    }
  }
  inputs = WithMasksOfFolders(inputs);
  for (const auto& [path, type] : outputs.empty() ? defaults : outputs)
  {
    CheckOutput(path, type, inputs);
  }
}
} // namespace palpate::cli
