#include "ZlibCheck.h"

#include "DecimalText.h"
#include "Refusal.h"

#include <algorithm>
#include <fstream>
#include <memory>
#include <vector>
#include <zlib.h>

namespace palpate
{
namespace
{
constexpr std::size_t InflationBuffer = std::size_t{1} << 17;
constexpr std::uint64_t MostInflatedBehind = std::uint64_t{1} << 20;
constexpr double MostInflatedFromByte = 1032.0; // of the deflate format

// Decodes the stream's input until there are more than `most` bytes. Returns zlib's state and
// counts the bytes.
int InflateInput(z_stream& stream, std::vector<unsigned char>& room, std::uint64_t most,
                 std::uint64_t& bytes)
{
  int state = Z_OK;
  do
  {
    stream.next_out = room.data();
    stream.avail_out = static_cast<uInt>(room.size());
    state = inflate(&stream, Z_NO_FLUSH);
    bytes += room.size() - stream.avail_out;
  } while (state == Z_OK && stream.avail_out == 0 && bytes <= most);
  // Z_BUF_ERROR only means that more input is needed.
  return state == Z_BUF_ERROR ? Z_OK : state;
}
} // namespace

std::uint64_t CheckedInflatedBytes(const std::filesystem::path& file, std::uint64_t start,
                                   std::uint64_t dataBytes, std::uint64_t mostBytes)
{
  const std::uint64_t mostDecoded =
      dataBytes + std::min(MostInflatedBehind, UINT64_MAX - dataBytes);
  std::ifstream input(file, std::ios::binary);
  input.seekg(static_cast<std::streamoff>(start));
  z_stream stream{};
  inflateInit2(&stream, MAX_WBITS + 32); // zlib or gzip by its first bytes
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, inflateEnd);
  std::vector<unsigned char> packed(InflationBuffer);
  std::vector<unsigned char> room(InflationBuffer);
  std::uint64_t bytes = 0;
  int state = Z_OK;
  while (state == Z_OK)
  {
    const auto wanted = std::min<std::uint64_t>(InflationBuffer, mostBytes);
    input.read(reinterpret_cast<char*>(packed.data()), static_cast<std::streamsize>(wanted));
    mostBytes -= static_cast<std::uint64_t>(input.gcount());
    stream.next_in = packed.data();
    stream.avail_in = static_cast<uInt>(input.gcount());
    if (stream.avail_in == 0)
    {
      Refuse(file, "is truncated: its compressed data end early", "copy or export it again");
    }
    state = InflateInput(stream, room, mostDecoded, bytes);
    if (bytes > mostDecoded)
    {
      Refuse(file,
             "is damaged: its compressed data go on for more than a megabyte behind its voxels",
             "copy or export it again");
    }
  }
  if (state != Z_STREAM_END)
  {
    Refuse(file, "is damaged: its compressed data do not decode or fail their checksum",
           "copy or export it again");
  }
  return bytes;
}

void CheckInflatedSize(const std::filesystem::path& file, double packedBytes, double dataBytes)
{
  if (!(dataBytes <= MostInflatedFromByte * packedBytes))
  {
    Refuse(file,
           "is truncated: its header declares " + SignificantText(dataBytes) +
               " bytes of voxels, and its " + SignificantText(packedBytes) +
               " compressed bytes cannot hold them",
           "copy or export it again");
  }
}
} // namespace palpate
