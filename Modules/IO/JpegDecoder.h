#pragma once

#include "CompressedFrame.h"
#include "PalpateIOModule.h"

namespace palpate
{
/// Decodes JPEG (baseline, extended and lossless, sequential, Huffman-coded) with DCMTK's builds of
/// the IJG library into `pixels`, which has room for the frame. False for a damaged stream, also
/// where the library would go on with a warning, and for one of another size, depth or number of
/// components than the frame. Source: ITU-T T.81.
[[nodiscard]] PALPATEIO_EXPORT bool DecodeJpeg(const CompressedFrame& frame, std::uint8_t* pixels);
} // namespace palpate
