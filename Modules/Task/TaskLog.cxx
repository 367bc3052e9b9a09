#include "TaskLog.h"

#include "Refusal.h"
#include "WholeFile.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace palpate
{
namespace
{
constexpr std::uintmax_t LargestLog = std::uintmax_t{64} << 20; // bytes

std::vector<std::string> CompleteLines(const std::string& text)
{
  std::vector<std::string> lines;
  std::size_t start = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', start))
  {
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

std::size_t BytesOf(const std::vector<std::string>& lines)
{
  std::size_t bytes = 0;
  for (const std::string& line : lines)
  {
    bytes += line.size() + 1;
  }
  return bytes;
}

// Lest a power failure takes the new file's name with it.
void SyncFolder(const std::filesystem::path& folder)
{
  const int file = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file >= 0)
  {
    fsync(file);
    close(file);
  }
}
} // namespace

TaskLog::TaskLog(const std::filesystem::path& path) : Path(path)
{
  constexpr mode_t OnlyUser = 0600;
  this->File = open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, OnlyUser);
  if (this->File < 0)
  {
    this->Fail("cannot be opened");
  }
  try
  {
    struct stat status = {};
    if (fstat(this->File, &status) != 0 || !S_ISREG(status.st_mode))
    {
      Refuse(path, "is not a file", "choose another folder");
    }
    if (flock(this->File, LOCK_EX | LOCK_NB) != 0)
    {
      Refuse(path, "is written by another program", "end the task there first");
    }
    if (status.st_size > 0)
    {
      this->Earlier = ReadLines(path);
      this->CutTo(BytesOf(this->Earlier));
    }
    SyncFolder(path.parent_path());
  }
  catch (...)
  {
    close(this->File);
    throw;
  }
}

TaskLog::~TaskLog()
{
  close(this->File);
}

void TaskLog::CutTo(std::size_t bytes) const
{
  if (ftruncate(this->File, static_cast<off_t>(bytes)) != 0)
  {
    this->Fail("cannot be repaired");
  }
}

void TaskLog::Fail(const std::string& what) const
{
  Refuse(this->Path, what + ": " + std::generic_category().message(errno),
         "check the folder's permissions and free disk space");
}

void TaskLog::Append(const std::string& line)
{
  const std::string bytes = line + '\n';
  std::string_view left = bytes;
  while (!left.empty())
  {
    const ssize_t written = write(this->File, left.data(), left.size());
    if (written < 0 && errno != EINTR)
    {
      this->Fail("cannot be written");
    }
    left.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
  if (fdatasync(this->File) != 0)
  {
    this->Fail("cannot be written");
  }
}

std::vector<std::string> TaskLog::ReadLines(const std::filesystem::path& path)
{
  return CompleteLines(ReadWholeFile(path, LargestLog));
}
} // namespace palpate
