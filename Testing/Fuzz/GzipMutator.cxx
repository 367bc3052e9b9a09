#include "GzipMutator.h"

#include "BinaryFields.h"
#include "SyntheticImages.h"

#include <utility>
#include <zlib.h>

namespace palpate::test
{
namespace
{
constexpr std::size_t LargestContent = 1U << 20U; // to mutate
constexpr std::size_t TrailerSize = 8;

std::string Unpacked(const std::string& packed)
{
  std::string content(LargestContent, '\0');
  z_stream stream{};
  constexpr int GzipOnly = 15 + 16;
  if (inflateInit2(&stream, GzipOnly) != Z_OK)
  {
    return {};
  }
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(content.data());
  stream.avail_out = static_cast<uInt>(content.size());
  inflate(&stream, Z_FINISH);
  content.resize(stream.total_out);
  inflateEnd(&stream);
  return content;
}

void ChangePacked(std::string& bytes, Random& random)
{
  switch (Below(random, 4))
  {
  case 0: // method, flags, time
    FieldMutator(FieldsFrom(0, 10, 1))(bytes, random);
    break;
  case 1: // checksum and length
    if (bytes.size() > TrailerSize)
    {
      FieldMutator(FieldsFrom(bytes.size() - TrailerSize, 2, 4))(bytes, random);
    }
    break;
  case 2:
    bytes += Below(random, 2) == 0 ? bytes : Gzipped("x");
    break;
  default:
    MutateBytes(bytes, random);
  }
}
} // namespace

Mutator GzipMutator(Mutator inner)
{
  return [change = std::move(inner)](std::string& bytes, Random& random)
  {
    if (Below(random, 4) == 0)
    {
      ChangePacked(bytes, random);
      return;
    }
    std::string content = Unpacked(bytes);
    change(content, random);
    if (Below(random, 100) == 0)
    {
      content.append(std::size_t{1} << (20 + Below(random, 7)), '\0');
    }
    bytes = Gzipped(content);
  };
}
} // namespace palpate::test
