#pragma once

#include "PalpateIOModule.h"

#include <string>

namespace palpate
{
enum class PixelCoding
{
  Native, ///< uncompressed
  RunLength,
  Jpeg, ///< baseline, extended and lossless
  JpegLs,
  Jpeg2000,
  Unread ///< any other, not supported
};

/// The coding of a transfer syntax. Source: DICOM PS3.5, 10 and annex A.
PALPATEIO_EXPORT PixelCoding PixelCodingOf(const std::string& transferSyntaxUid);

/// Name and UID of a transfer syntax for messages; the UID alone if its name is unknown.
PALPATEIO_EXPORT std::string TransferSyntaxName(const std::string& transferSyntaxUid);
} // namespace palpate
