#include "GzipFile.h"

#include "Refusal.h"

#include <algorithm>
#include <string>
#include <vector>
#include <zlib.h>

namespace palpate
{
namespace
{
constexpr unsigned int BufferBytes = 1U << 17;
constexpr std::size_t MostBytesBehind = std::size_t{1} << 20;
} // namespace

GzipFile::GzipFile(const std::filesystem::path& file)
    : File(file), Stream(gzopen(file.c_str(), "rb"), gzclose)
{
  if (!this->Stream)
  {
    Refuse(file, "cannot be opened", "check its permissions");
  }
  gzbuffer(this->Stream.get(), BufferBytes);
}

int GzipFile::ReadSome(void* buffer, std::size_t bytes)
{
  const int got = gzread(this->Stream.get(), buffer, static_cast<unsigned int>(bytes));
  int state = Z_OK;
  gzerror(this->Stream.get(), &state);
  if (state == Z_BUF_ERROR)
  {
    Refuse(this->File, "is truncated: its compressed data end early", "copy or export it again");
  }
  if (got < 0 || state != Z_OK)
  {
    Refuse(this->File, "is damaged: its compressed data do not decode or fail their checksum",
           "copy or export it again");
  }
  return got;
}

void GzipFile::Read(void* buffer, std::size_t bytes)
{
  char* target = static_cast<char*>(buffer);
  while (bytes > 0)
  {
    const auto got = this->ReadSome(target, std::min<std::size_t>(bytes, BufferBytes));
    if (got == 0)
    {
      Refuse(this->File,
             "is truncated: it ends after " + std::to_string(gztell(this->Stream.get())) +
                 " bytes, but its header declares more",
             "copy or export it again");
    }
    target += got;
    bytes -= static_cast<std::size_t>(got);
  }
}

void GzipFile::Skip(std::size_t bytes)
{
  std::vector<char> passed(std::min<std::size_t>(bytes, BufferBytes));
  while (bytes > 0)
  {
    const std::size_t step = std::min(bytes, passed.size());
    this->Read(passed.data(), step);
    bytes -= step;
  }
}

void GzipFile::ReadToEnd()
{
  if (gzdirect(this->Stream.get()) != 0)
  {
    return;
  }
  std::vector<char> rest(BufferBytes);
  int got = 0;
  std::size_t bytes = 0;
  while ((got = this->ReadSome(rest.data(), rest.size())) > 0)
  {
    bytes += static_cast<std::size_t>(got);
    if (bytes > MostBytesBehind)
    {
      Refuse(this->File,
             "is damaged: its compressed data go on for more than a megabyte behind its voxels",
             "copy or export it again");
    }
  }
}
} // namespace palpate
