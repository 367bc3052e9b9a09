#include "OutputFolder.h"

#include "Refusal.h"

#include <string>
#include <system_error>
#include <unistd.h>

namespace palpate
{
namespace
{
[[noreturn]] void RefuseFolder(const std::filesystem::path& folder, const std::string& reason)
{
  Refuse(folder, "cannot be made as a folder (" + reason + ")", "choose another with --output");
}

// The part of the path that is there already; "." for a relative path of which nothing is.
std::filesystem::path ExistingPart(std::filesystem::path path)
{
  std::error_code ignored;
  while (!path.empty() && !std::filesystem::exists(path, ignored))
  {
    if (path == path.root_path())
    {
      return path;
    }
    path = path.parent_path();
  }
  return path.empty() ? std::filesystem::path(".") : path;
}
} // namespace

void CheckOutputFolder(const std::filesystem::path& folder)
{
  const std::filesystem::path existing = ExistingPart(folder);
  std::error_code ignored;
  if (!std::filesystem::is_directory(existing, ignored))
  {
    RefuseFolder(folder, existing.string() + " is no folder");
  }
  if (access(existing.c_str(), W_OK | X_OK) != 0)
  {
    RefuseFolder(folder, existing.string() + " may not be written to");
  }
}

void MakeOutputFolder(const std::filesystem::path& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
  {
    RefuseFolder(folder, error.message());
  }
  if (!std::filesystem::is_directory(folder, error))
  {
    RefuseFolder(folder, "a file has that name");
  }
}
} // namespace palpate
