#include "WholeFile.h"

#include "AtomicFile.h"
#include "Refusal.h"

#include <cerrno>
#include <fstream>
#include <system_error>

namespace palpate
{
std::uintmax_t InputFileSize(const std::filesystem::path& path)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
  {
    Refuse(path, "does not exist", "check the path");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    Refuse(path, "is not a file", "specify a file");
  }
  if (!std::ifstream(path, std::ios::binary))
  {
    Refuse(path, "cannot be opened", "check its permissions");
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error)
  {
    Refuse(path, "cannot be read: " + error.message(), "check its permissions");
  }
  if (size == 0)
  {
    Refuse(path, "is empty", "copy or export it again");
  }
  return size;
}

std::string ReadWholeFile(const std::filesystem::path& path, std::uintmax_t maximumBytes)
{
  const std::uintmax_t size = InputFileSize(path);
  if (size > maximumBytes)
  {
    Refuse(path,
           "has " + std::to_string(size) + " bytes, more than the " + std::to_string(maximumBytes) +
               " allowed for such a file",
           "check the name");
  }
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
  {
    Refuse(path, "cannot be read to its end", "check its permissions");
  }
  return bytes;
}

void WriteWholeFile(const std::filesystem::path& path, std::string_view bytes)
{
  WriteWholeFile(path, [bytes](std::ostream& stream)
                 { stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size())); });
}

void WriteWholeFile(const std::filesystem::path& path,
                    const std::function<void(std::ostream&)>& write)
{
  AtomicFile file(path);
  errno = 0;
  std::ofstream stream(file.TemporaryPath(), std::ios::binary | std::ios::trunc);
  write(stream);
  stream.close();
  if (!stream)
  {
    const std::string reason =
        errno != 0 ? std::generic_category().message(errno) : "writing stopped early";
    Refuse(path, "cannot be written: " + reason, "free disk space or choose another output");
  }
  file.Commit();
}
} // namespace palpate
