#include "AtomicFile.h"

#include "Refusal.h"

#include <cerrno>
#include <fcntl.h>
#include <random>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace palpate
{
namespace
{
// File names may have 255 bytes; the longest ending in use is far shorter than this.
constexpr std::size_t KeptEnding = 32;
constexpr int MaximumTries = 1000;

[[noreturn]] void RefuseOutput(const std::filesystem::path& path, const std::string& fact)
{
  Refuse(path, "cannot be written: " + fact, "choose another output");
}

std::string SystemMessage(int error)
{
  return std::generic_category().message(error);
}

std::filesystem::path FolderOf(const std::filesystem::path& file)
{
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

std::filesystem::path TemporaryName(const std::filesystem::path& target)
{
  const std::string name = target.filename().string();
  const std::string ending =
      name.size() > KeptEnding ? name.substr(name.size() - KeptEnding) : name;
  return FolderOf(target) / (".palpate-" + std::to_string(std::random_device()()) + "-" + ending);
}

// What stands in the way of writing, or nothing.
std::string Obstacle(const std::filesystem::path& target)
{
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(target, ignored);
  if (!target.has_filename())
  {
    return "it names no file";
  }
  if (std::filesystem::is_directory(status))
  {
    return "it is a folder";
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    return "it is no regular file";
  }
  if (std::filesystem::exists(status) && access(target.c_str(), W_OK) != 0)
  {
    return "the existing file is write-protected";
  }
  if (!std::filesystem::is_directory(FolderOf(target), ignored))
  {
    return "there is no folder " + FolderOf(target).string();
  }
  return {};
}
} // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path) : Requested(path), Target(path)
{
  std::error_code ignored;
  if (std::filesystem::is_symlink(path, ignored))
  {
    this->Target = std::filesystem::weakly_canonical(path, ignored);
  }
  const std::string obstacle = Obstacle(this->Target);
  if (!obstacle.empty())
  {
    RefuseOutput(path, obstacle);
  }
  int file = -1;
  for (int tries = 0; file < 0 && tries < MaximumTries; ++tries)
  {
    this->Temporary = TemporaryName(this->Target);
    file = open(this->Temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0 && errno != EEXIST)
    {
      RefuseOutput(path, SystemMessage(errno));
    }
  }
  if (file < 0)
  {
    RefuseOutput(path, "its folder is full of temporary files");
  }
  close(file);
}

AtomicFile::~AtomicFile()
{
  if (!this->Committed)
  {
    std::error_code ignored;
    std::filesystem::remove(this->Temporary, ignored);
  }
}

void AtomicFile::Commit()
{
  struct stat old = {};
  if (stat(this->Target.c_str(), &old) == 0 &&
      chmod(this->Temporary.c_str(), old.st_mode & 07777) != 0)
  {
    RefuseOutput(this->Requested, SystemMessage(errno));
  }
  std::error_code error;
  std::filesystem::rename(this->Temporary, this->Target, error);
  if (error)
  {
    RefuseOutput(this->Requested, error.message());
  }
  this->Committed = true;
}
} // namespace palpate
