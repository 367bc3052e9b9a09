#pragma once

#include "PalpateIOModule.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace palpate
{
/// Image properties declared by a JPEG or JPEG-LS stream, read without decoding it.
struct JpegFrameHeader
{
  /// Last bytes of the markers of sequential, Huffman-coded frames.
  static constexpr int Baseline = 0xC0;
  static constexpr int Extended = 0xC1;
  static constexpr int Lossless = 0xC3;
  static constexpr int JpegLs = 0xF7;

  int Marker = 0;    ///< last byte of the frame's marker
  int Precision = 0; ///< bits per sample
  int Rows = 0;
  int Columns = 0;
  int Components = 0;
};

/// From the first frame segment; empty if the marker segments do not lead to one. Sources: ITU-T
/// T.81, B.1 and B.2.2; T.87, C.2.2.
PALPATEIO_EXPORT std::optional<JpegFrameHeader>
ReadJpegFrameHeader(const std::vector<std::uint8_t>& stream);
} // namespace palpate
