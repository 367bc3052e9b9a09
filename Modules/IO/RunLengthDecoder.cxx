#include "RunLengthDecoder.h"

namespace palpate
{
namespace
{
// The header: a count and 15 offsets, four bytes each, little-endian.
constexpr std::size_t HeaderBytes = 64;

std::size_t HeaderWord(const std::vector<std::uint8_t>& stream, std::size_t word)
{
  std::uint32_t value = 0;
  for (std::size_t byte = 0; byte < 4; ++byte)
  {
    value |= std::uint32_t{stream[4 * word + byte]} << (8 * byte);
  }
  return value;
}

struct Bytes
{
  const std::uint8_t* Next;
  const std::uint8_t* End;
};

// Unpacks `count` bytes into every `step`-th byte from `output` on; false where they end before.
bool Unpack(Bytes packed, std::size_t count, std::size_t step, std::uint8_t* output)
{
  std::size_t done = 0;
  while (done < count && packed.Next != packed.End)
  {
    const unsigned int code = *packed.Next++;
    if (code == 128) // means nothing
    {
      continue;
    }
    const bool isRun = code > 128;
    const std::size_t length = isRun ? 257 - code : code + 1;
    const std::size_t used = isRun ? 1 : length;
    if (length > count - done || used > static_cast<std::size_t>(packed.End - packed.Next))
    {
      return false;
    }
    for (std::size_t i = 0; i < length; ++i)
    {
      output[(done + i) * step] = packed.Next[isRun ? 0 : i];
    }
    packed.Next += used;
    done += length;
  }
  return done == count;
}
} // namespace

bool DecodeRunLength(const CompressedFrame& frame, std::uint8_t* pixels)
{
  const std::vector<std::uint8_t>& stream = frame.Stream;
  const auto segments = static_cast<std::size_t>(frame.BytesPerPixel);
  if (stream.size() < HeaderBytes || HeaderWord(stream, 0) != segments)
  {
    return false;
  }
  // One segment for each byte of the pixels, the most significant first.
  for (std::size_t segment = 0; segment < segments; ++segment)
  {
    const std::size_t start = HeaderWord(stream, segment + 1);
    const std::size_t end =
        segment + 1 == segments ? stream.size() : HeaderWord(stream, segment + 2);
    if (start < HeaderBytes || start > end || end > stream.size() ||
        !Unpack({stream.data() + start, stream.data() + end}, frame.PixelCount(), segments,
                pixels + (segments - 1 - segment)))
    {
      return false;
    }
  }
  return true;
}
} // namespace palpate
