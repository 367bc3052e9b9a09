#pragma once

#include "CompressedFrame.h"
#include "PalpateIOModule.h"

namespace palpate
{
/// Decodes a JPEG 2000 codestream (lossless or lossy; JP2 boxes around it are skipped) with
/// OpenJPEG into `pixels`, which must be large enough. Returns false if the stream is damaged or
/// its size, depth or number of components differ from the frame's. Source: ITU-T T.800.
[[nodiscard]] PALPATEIO_EXPORT bool DecodeJpeg2000(const CompressedFrame& frame,
                                                   std::uint8_t* pixels);
} // namespace palpate
