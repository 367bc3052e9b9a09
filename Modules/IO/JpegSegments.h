#pragma once

#include "PalpateIOModule.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace palpate
{
/// A marker segment of a JPEG or JPEG-LS stream.
struct JpegSegment
{
  int Marker = 0;        ///< the byte after 0xFF
  std::size_t First = 0; ///< of its content, after the length field
  std::size_t End = 0;
};

/// Last bytes of the markers that are looked for.
struct JpegMarker
{
  static constexpr int BaselineFrame = 0xC0;
  static constexpr int ExtendedFrame = 0xC1;
  static constexpr int LosslessFrame = 0xC3;
  static constexpr int JpegLsFrame = 0xF7;
  static constexpr int JpegLsParameters = 0xF8;
  static constexpr int RestartInterval = 0xDD;
  static constexpr int Scan = 0xDA;
};

/// What a stream says of its image before any of it is decoded.
struct JpegFrameHeader
{
  int Process = 0;   ///< marker of the frame
  int Precision = 0; ///< bits a sample
  int Rows = 0;
  int Columns = 0;
  int Components = 0;
};

/// The segments before the first scan, and that scan's own, which is the last. Empty where they do
/// not lead to a scan. Source: ITU-T T.81, B.1.
PALPATEIO_EXPORT std::vector<JpegSegment> ReadJpegSegments(const std::vector<std::uint8_t>& stream);

/// The two bytes at `place`, most significant first.
inline int JpegWord(const std::vector<std::uint8_t>& stream, std::size_t place)
{
  return stream[place] << 8 | stream[place + 1];
}

/// From the only frame segment; empty where there is none, or several. Sources: ITU-T T.81, B.2.2;
/// T.87, C.2.2.
PALPATEIO_EXPORT std::optional<JpegFrameHeader>
ReadJpegFrameHeader(const std::vector<std::uint8_t>& stream,
                    const std::vector<JpegSegment>& segments);
} // namespace palpate
