#pragma once

#include "CompressedFrame.h"
#include "PalpateIOModule.h"

namespace palpate
{
/// Decodes JPEG (baseline, extended, lossless) and JPEG-LS with DCMTK's codecs into `pixels`, which
/// has room for the frame. False for a damaged stream, and for one of another size, depth or number
/// of components than the frame. Call it while a DicomDataset lives: its lock guards DCMTK's list
/// of codecs, and the codecs print.
[[nodiscard]] PALPATEIO_EXPORT bool DecodeWithDcmtk(const CompressedFrame& frame,
                                                    std::uint8_t* pixels);
} // namespace palpate
