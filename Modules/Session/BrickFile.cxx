#include "BrickFile.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <unistd.h>

namespace palpate
{
namespace
{
Status Failure(const std::string& what)
{
  return Status::Failure(what + ": " + std::strerror(errno) + ".");
}

// All of it, however little a call does.
template <typename Transfer>
bool TransferAll(std::size_t bytes, const Transfer& transfer)
{
  std::size_t done = 0;
  while (done < bytes)
  {
    const ssize_t more = transfer(done, bytes - done);
    if (more <= 0 && !(more < 0 && errno == EINTR))
    {
      errno = more == 0 ? EIO : errno;
      return false;
    }
    done += more > 0 ? static_cast<std::size_t>(more) : 0;
  }
  return true;
}
} // namespace

BrickFile::~BrickFile()
{
  close(this->File);
}

Status BrickFile::Make(const ScalarField& whole, const std::filesystem::path& folder,
                       std::unique_ptr<BrickSource>& source)
{
  const std::string problem = "Bricks cannot be kept in " + folder.string();
  std::string name = (folder / "palpate-bricks-XXXXXX").string();
  const int file = mkstemp(name.data());
  if (file < 0)
  {
    return Failure(problem);
  }
  unlink(name.c_str());
  const RecordLayout layout(whole);
  std::unique_ptr<BrickSource> made(new BrickFile(file, layout.Bytes()));
  Status status = ForEachRecord(whole, layout,
                                [&](const std::byte* record)
                                {
                                  const bool isWritten = TransferAll(
                                      layout.Bytes(), [&](std::size_t done, std::size_t left)
                                      { return write(file, record + done, left); });
                                  return isWritten ? Status::Success() : Failure(problem);
                                });
  if (status.IsOk())
  {
    source = std::move(made);
  }
  return status;
}

Status BrickFile::Read(std::uint32_t number, std::byte* record)
{
  const auto begin = static_cast<off_t>(number) * static_cast<off_t>(this->RecordBytes);
  const bool isRead = TransferAll(
      this->RecordBytes, [&](std::size_t done, std::size_t left)
      { return pread(this->File, record + done, left, begin + static_cast<off_t>(done)); });
  return isRead ? Status::Success() : Failure("A brick cannot be read back");
}
} // namespace palpate
