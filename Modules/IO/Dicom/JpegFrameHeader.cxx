#include "JpegFrameHeader.h"

#include <cstddef>

namespace palpate
{
namespace
{
// The two bytes at `place`, most significant first.
int Word(const std::vector<std::uint8_t>& stream, std::size_t place)
{
  return stream[place] << 8 | stream[place + 1];
}

bool IsFrame(int marker)
{
  const bool isTable = marker == 0xC4 || marker == 0xC8 || marker == 0xCC;
  return (marker >= 0xC0 && marker <= 0xCF && !isTable) || marker == JpegFrameHeader::JpegLs;
}
} // namespace

std::optional<JpegFrameHeader> ReadJpegFrameHeader(const std::vector<std::uint8_t>& stream)
{
  constexpr std::size_t HeaderBytes = 10; // marker, length and the fields that are read
  if (stream.size() < 2 || Word(stream, 0) != 0xFFD8)
  {
    return std::nullopt;
  }
  for (std::size_t place = 2; place + HeaderBytes <= stream.size() && stream[place] == 0xFF;)
  {
    const int marker = stream[place + 1];
    if (IsFrame(marker))
    {
      return JpegFrameHeader{marker, stream[place + 4], Word(stream, place + 5),
                             Word(stream, place + 7), stream[place + 9]};
    }
    // 0xFF may be repeated before a marker.
    place += marker == 0xFF ? 1 : 2 + static_cast<std::size_t>(Word(stream, place + 2));
  }
  return std::nullopt;
}
} // namespace palpate
