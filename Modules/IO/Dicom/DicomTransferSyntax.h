#pragma once

#include "PalpateIOModule.h"

#include <string>

namespace palpate
{
/// How a DICOM file codes its pixels, as far as reading them goes.
enum class PixelCoding
{
  Native, ///< uncompressed
  RunLength,
  Jpeg, ///< baseline, extended and lossless
  JpegLs,
  Jpeg2000,
  Unread ///< any other
};

/// The coding that a transfer syntax stands for. Source: DICOM PS3.5, 10 and annex A.
PALPATEIO_EXPORT PixelCoding PixelCodingOf(const std::string& transferSyntaxUid);

/// Name and UID of a transfer syntax for a sentence; the UID alone where it has no known name.
PALPATEIO_EXPORT std::string TransferSyntaxName(const std::string& transferSyntaxUid);
} // namespace palpate
