#include "TemporaryFile.h"

#include <cerrno>
#include <fcntl.h>
#include <random>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace palpate
{
namespace
{
constexpr int MaximumTries = 1000;

std::string SystemMessage(int error)
{
  return std::generic_category().message(error);
}

std::filesystem::path FolderOf(const std::filesystem::path& file)
{
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

// The reason why the target cannot be written, or an empty text.
std::string Obstacle(const std::filesystem::path& target)
{
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(target, ignored);
  if (!target.has_filename())
  {
    return "it has no file name";
  }
  if (std::filesystem::is_directory(status))
  {
    return "it is a folder";
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    return "it is not a regular file";
  }
  // A link is replaced itself, so the permissions of the file behind it do not matter.
  if (std::filesystem::exists(status) && !std::filesystem::is_symlink(target, ignored) &&
      access(target.c_str(), W_OK) != 0)
  {
    return "the existing file is write-protected";
  }
  if (!std::filesystem::is_directory(FolderOf(target), ignored))
  {
    return "there is no folder " + FolderOf(target).string();
  }
  return {};
}

// Waits until the data of a file or folder is on the disk. Opens it by name, since image writers
// may have replaced the file that was opened first. Does nothing where the file system does not
// support it (EINVAL) or the umask forbids opening the file.
bool Sync(const std::filesystem::path& path, int kind)
{
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | kind);
  const bool isSynced = file >= 0 && fsync(file) == 0;
  const int error = errno;
  if (file >= 0)
  {
    close(file);
  }
  errno = error;
  return isSynced || error == EINVAL || error == EACCES;
}
} // namespace

TemporaryFile::~TemporaryFile()
{
  this->Close();
  if (!this->Temporary.empty())
  {
    unlink(this->Temporary.c_str());
  }
}

void TemporaryFile::Close() noexcept
{
  if (this->File >= 0)
  {
    close(this->File);
    this->File = -1;
  }
}

void TemporaryFile::Keep() noexcept
{
  this->Close();
  this->Temporary.clear();
}

Status TemporaryFile::Create(const std::filesystem::path& target, const std::string& prefix,
                             const std::string& suffix)
{
  this->Final = target;
  if (const std::string obstacle = Obstacle(this->Final); !obstacle.empty())
  {
    return Status::Failure(obstacle);
  }
  for (int tries = 0; tries < MaximumTries; ++tries)
  {
    const std::string name = prefix + std::to_string(std::random_device()()) + suffix;
    const std::filesystem::path path = FolderOf(this->Final) / name;
    this->File = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (this->File >= 0)
    {
      this->Temporary = path;
      return Status::Success();
    }
    if (errno != EEXIST)
    {
      return Status::Failure(SystemMessage(errno));
    }
  }
  return Status::Failure("its folder is full of temporary files");
}

Status TemporaryFile::Publish()
{
  struct stat old = {};
  const bool isReplaced = lstat(this->Final.c_str(), &old) == 0 && S_ISREG(old.st_mode);
  if (!Sync(this->Temporary, O_NOFOLLOW) ||
      (isReplaced && chmod(this->Temporary.c_str(), old.st_mode & 07777) != 0) ||
      std::rename(this->Temporary.c_str(), this->Final.c_str()) != 0)
  {
    return Status::Failure(SystemMessage(errno));
  }
  this->Keep();
  // The rename has succeeded, whatever follows. An unreadable folder cannot be synchronised.
  static_cast<void>(Sync(FolderOf(this->Final), O_DIRECTORY));
  return Status::Success();
}
} // namespace palpate
