#pragma once

#include "CompressedFrame.h"
#include "PalpateIOModule.h"

namespace palpate
{
/// Decodes a JPEG 2000 codestream (lossless or lossy; a JP2 file's boxes around it are passed over)
/// with OpenJPEG into `pixels`, which has room for the frame. False for a damaged stream, and for
/// one of another size, depth or number of components than the frame. Source: ITU-T T.800.
[[nodiscard]] PALPATEIO_EXPORT bool DecodeJpeg2000(const CompressedFrame& frame,
                                                   std::uint8_t* pixels);
} // namespace palpate
