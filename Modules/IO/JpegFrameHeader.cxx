#include "JpegFrameHeader.h"

#include <cstddef>

namespace palpate
{
namespace
{
bool IsStartOfFrame(int marker)
{
  const bool isTable = marker == 0xC4 || marker == 0xC8 || marker == 0xCC;
  return (marker >= 0xC0 && marker <= 0xCF && !isTable) || marker == 0xF7;
}

int Word(const std::vector<std::uint8_t>& stream, std::size_t place)
{
  return stream[place] << 8 | stream[place + 1];
}
} // namespace

std::optional<JpegFrameHeader> ReadJpegFrameHeader(const std::vector<std::uint8_t>& stream)
{
  if (stream.size() < 2 || Word(stream, 0) != 0xFFD8)
  {
    return std::nullopt;
  }
  // A marker segment: 0xFF (perhaps repeated), the marker, the length of what follows.
  for (std::size_t place = 2; place + 10 <= stream.size();)
  {
    const int marker = stream[place + 1];
    if (stream[place] != 0xFF)
    {
      return std::nullopt;
    }
    if (marker == 0xFF)
    {
      ++place;
      continue;
    }
    if (IsStartOfFrame(marker))
    {
      return JpegFrameHeader{marker, stream[place + 4], Word(stream, place + 5),
                             Word(stream, place + 7), stream[place + 9]};
    }
    if (marker == 0xDA || marker == 0xD9) // start of scan, end of image
    {
      return std::nullopt;
    }
    place += 2 + static_cast<std::size_t>(Word(stream, place + 2));
  }
  return std::nullopt;
}
} // namespace palpate
