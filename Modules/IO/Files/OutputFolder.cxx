#include "OutputFolder.h"

#include "AtomicFile.h"
#include "EarlierFiles.h"
#include "InputError.h"
#include "Refusal.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <list>
#include <system_error>
#include <unistd.h>

namespace palpate
{
namespace
{
[[noreturn]] void RefuseFolder(const std::filesystem::path& folder, const std::string& reason)
{
  Refuse(folder, "cannot be created as a folder (" + reason + ")", "choose another with --output");
}

// The existing part of the path; "." for a relative path of which nothing exists.
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

/// Creates a folder and its missing parents; the destructor removes those that are still empty.
class NewFolder
{
public:
  explicit NewFolder(const std::filesystem::path& folder)
  {
    std::error_code ignored;
    for (std::filesystem::path path = folder;
         !path.empty() && !std::filesystem::exists(path, ignored); path = path.parent_path())
    {
      this->Made.push_back(path);
    }
    try
    {
      MakeOutputFolder(folder);
    }
    catch (...)
    {
      this->RemoveEmpty();
      throw;
    }
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;
  ~NewFolder() { this->RemoveEmpty(); }

private:
  void RemoveEmpty() noexcept
  {
    for (const std::filesystem::path& path : this->Made)
    {
      rmdir(path.c_str());
    }
  }

  std::vector<std::filesystem::path> Made; // innermost first
};

/// A folder with an unused name within another one; the destructor removes it and its content.
class StagingFolder
{
public:
  explicit StagingFolder(const std::filesystem::path& parent)
  {
    std::string pattern = (parent / ".palpate-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
    {
      RefuseFolder(parent, std::generic_category().message(errno));
    }
    this->Folder = pattern;
  }
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;
  ~StagingFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Folder, ignored);
  }

  const std::filesystem::path& Path() const { return this->Folder; }
  std::vector<std::string> Names() const
  {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(this->Folder))
    {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

private:
  std::filesystem::path Folder;
};

// Checks everything that can be checked before the first file is renamed.
void Move(const std::vector<std::string>& names, const std::filesystem::path& from,
          const std::filesystem::path& to)
{
  std::list<AtomicFile> files;
  for (const std::string& name : names)
  {
    const AtomicFile& file = files.emplace_back(to / name);
    std::error_code error;
    std::filesystem::rename(from / name, file.TemporaryPath(), error);
    if (error) // through a link, on another disk
    {
      std::filesystem::copy_file(from / name, file.TemporaryPath(),
                                 std::filesystem::copy_options::overwrite_existing, error);
    }
    if (error)
    {
      Refuse(to / name, "cannot be written: " + error.message(),
             "free disk space or choose another output");
    }
  }
  for (AtomicFile& file : files)
  {
    file.Commit();
  }
}

void RemoveFile(const std::filesystem::path& file)
{
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
  {
    return; // not one of our files
  }
  std::filesystem::remove(file, error);
  if (error)
  {
    throw InputError(file.string() + " of an earlier run cannot be removed (" + error.message() +
                     "); choose another folder with --output");
  }
}

std::string Replaced(std::string text, const std::string& what, const std::string& with)
{
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + with.size()))
  {
    text.replace(at, what.size(), with);
  }
  return text;
}
} // namespace

bool HasFileEnding(const std::filesystem::path& path)
{
  constexpr std::size_t Longest = 5;
  const std::string ending = path.extension().string();
  const auto isOf = [&ending](int (*is)(int))
  {
    return std::all_of(ending.begin() + 1, ending.end(),
                       [is](unsigned char letter)
                       { return is(letter) != 0 || std::isdigit(letter) != 0; });
  };
  std::error_code ignored;
  return ending.size() > 2 && ending.size() <= Longest + 1 &&
         std::isalpha(static_cast<unsigned char>(ending[1])) != 0 &&
         (isOf(&std::islower) || isOf(&std::isupper)) &&
         !std::filesystem::is_directory(path, ignored);
}

void CheckOutputFolder(const std::filesystem::path& folder)
{
  if (HasFileEnding(folder))
  {
    Refuse(folder, "has the ending of a file, but a folder is written",
           "choose a name without an ending, or end it with / if that is meant");
  }
  const std::filesystem::path existing = ExistingPart(folder);
  std::error_code ignored;
  if (!std::filesystem::is_directory(existing, ignored))
  {
    RefuseFolder(folder, existing.string() + " is not a folder");
  }
  if (access(existing.c_str(), W_OK | X_OK) != 0)
  {
    RefuseFolder(folder, existing.string() + " is not writable");
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

void WriteOutputSet(const std::filesystem::path& folder,
                    const std::function<void(const std::filesystem::path& folder)>& write,
                    const std::vector<std::string>& obsolete)
{
  const NewFolder made(folder);
  const StagingFolder stage(folder);
  try
  {
    write(stage.Path());
  }
  catch (const InputError& error)
  {
    throw InputError(Replaced(error.what(), stage.Path().string(), folder.string()));
  }
  const std::vector<std::string> names = stage.Names();
  std::vector<std::string> replaced = names;
  replaced.insert(replaced.end(), obsolete.begin(), obsolete.end());
  RequireEarlierFiles(folder, replaced);
  Move(names, stage.Path(), folder);
  for (const std::string& name : obsolete)
  {
    if (!std::binary_search(names.begin(), names.end(), name))
    {
      RemoveFile(folder / name);
    }
  }
}
} // namespace palpate
