#include "MaskFolders.h"

#include "CohortManifest.h"
#include "FileKind.h"
#include "InputError.h"

#include <filesystem>

namespace palpate::cli
{
namespace
{
bool IsFolderOfFiles(const std::string& input)
{
  std::error_code ignored;
  return std::filesystem::is_directory(input, ignored) && DicomFilesIn(input).empty();
}
} // namespace

std::vector<std::string> WithMasksOfFolders(const std::vector<std::string>& inputs)
{
  std::vector<std::string> files;
  for (const std::string& input : inputs)
  {
    try
    {
      if (IsFolderOfFiles(input))
      {
        for (const std::filesystem::path& mask : FindMasks(input))
        {
          files.push_back(mask.string());
        }
        continue;
      }
    }
    catch (const InputError&)
    {
      // The command has its own message for such a folder.
    }
    files.push_back(input);
  }
  return files;
}
} // namespace palpate::cli
