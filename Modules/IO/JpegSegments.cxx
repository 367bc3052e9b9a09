#include "JpegSegments.h"

namespace palpate
{
namespace
{
bool IsFrame(int marker)
{
  const bool isTable = marker == 0xC4 || marker == 0xC8 || marker == 0xCC;
  return (marker >= 0xC0 && marker <= 0xCF && !isTable) || marker == JpegMarker::JpegLsFrame;
}
} // namespace

std::vector<JpegSegment> ReadJpegSegments(const std::vector<std::uint8_t>& stream)
{
  std::vector<JpegSegment> segments;
  if (stream.size() < 2 || JpegWord(stream, 0) != 0xFFD8)
  {
    return segments;
  }
  for (std::size_t place = 2; place + 4 <= stream.size();)
  {
    if (stream[place] != 0xFF)
    {
      return {};
    }
    if (stream[place + 1] == 0xFF) // 0xFF may be repeated
    {
      ++place;
      continue;
    }
    const auto length = static_cast<std::size_t>(JpegWord(stream, place + 2));
    const JpegSegment segment{stream[place + 1], place + 4, place + 2 + length};
    if (length < 2 || segment.End > stream.size())
    {
      return {};
    }
    segments.push_back(segment);
    if (segment.Marker == JpegMarker::Scan)
    {
      return segments;
    }
    place = segment.End;
  }
  return {};
}

std::optional<JpegFrameHeader> ReadJpegFrameHeader(const std::vector<std::uint8_t>& stream,
                                                   const std::vector<JpegSegment>& segments)
{
  std::optional<JpegFrameHeader> header;
  for (const JpegSegment& segment : segments)
  {
    if (!IsFrame(segment.Marker))
    {
      continue;
    }
    if (header || segment.End - segment.First < 6)
    {
      return std::nullopt;
    }
    header =
        JpegFrameHeader{segment.Marker, stream[segment.First], JpegWord(stream, segment.First + 1),
                        JpegWord(stream, segment.First + 3), stream[segment.First + 5]};
  }
  return header;
}
} // namespace palpate
