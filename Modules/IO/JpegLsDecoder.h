#pragma once

#include "CompressedFrame.h"
#include "PalpateIOModule.h"

namespace palpate
{
/// Decodes JPEG-LS (lossless and near-lossless) into `pixels`, which has room for the frame. False
/// for a damaged stream and for one that ReadJpegLsParameters does not take. It is decoded here,
/// because Debian builds the CharLS of DCMTK with its assertions on, and a damaged stream can
/// violate them. Source: ITU-T T.87 (ISO/IEC 14495-1).
[[nodiscard]] PALPATEIO_EXPORT bool DecodeJpegLs(const CompressedFrame& frame,
                                                 std::uint8_t* pixels);
} // namespace palpate
