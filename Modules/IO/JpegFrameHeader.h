#pragma once

#include "PalpateIOModule.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace palpate
{
/// What a JPEG or JPEG-LS stream says of its image before any of it is decoded.
struct JpegFrameHeader
{
  /// Last byte of the start-of-frame marker: 0xC0 baseline, 0xC1 extended, 0xC3 lossless, 0xF7
  /// JPEG-LS; others are not sequential Huffman coding.
  int Process = 0;
  int Precision = 0; ///< bits a sample
  int Rows = 0;
  int Columns = 0;
  int Components = 0;
};

/// Empty where the markers do not lead to a start of frame. Sources: ITU-T T.81, B.2; T.87, C.2.
PALPATEIO_EXPORT std::optional<JpegFrameHeader>
ReadJpegFrameHeader(const std::vector<std::uint8_t>& stream);
} // namespace palpate
