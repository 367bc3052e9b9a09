#include "FolderLock.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace palpate
{
namespace
{
int OpenLock(const std::filesystem::path& path)
{
  constexpr int Flags = O_CREAT | O_CLOEXEC | O_NOFOLLOW;
  const int file = open(path.c_str(), Flags | O_RDWR, 0666);
  // Another user's file: opening it for reading is enough for a lock, but not on every file system.
  return file < 0 && errno == EACCES ? open(path.c_str(), Flags | O_RDONLY, 0666) : file;
}

// Returns 0 or errno.
int Lock(int file, int operation)
{
  while (flock(file, operation) != 0)
  {
    if (errno != EINTR)
    {
      return errno;
    }
  }
  return 0;
}

// Whether the file still exists, that is, was not removed by its previous holder.
bool IsThere(int file, const std::filesystem::path& path)
{
  struct stat opened = {};
  struct stat named = {};
  return fstat(file, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}
} // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, const std::string& name)
    : Path(folder / name)
{
}

FolderLock::~FolderLock()
{
  // Among shared holders, only the last one gets the exclusive lock.
  if (this->File >= 0 && Lock(this->File, LOCK_EX | LOCK_NB) == 0 &&
      IsThere(this->File, this->Path))
  {
    unlink(this->Path.c_str());
  }
  this->Release();
}

void FolderLock::Release() noexcept
{
  if (this->File >= 0)
  {
    close(this->File);
    this->File = -1;
  }
}

bool FolderLock::Take(int operation)
{
  while (true)
  {
    this->File = this->File >= 0 ? this->File : OpenLock(this->Path);
    if (this->File < 0)
    {
      return true;
    }
    const int error = Lock(this->File, operation);
    if (error != 0 || IsThere(this->File, this->Path))
    {
      return error != EWOULDBLOCK;
    }
    this->Release();
  }
}

void FolderLock::WaitAlone()
{
  this->Take(LOCK_EX);
}

bool FolderLock::TryAlone()
{
  return this->Take(LOCK_EX | LOCK_NB);
}

void FolderLock::Share()
{
  this->Take(LOCK_SH);
}
} // namespace palpate
