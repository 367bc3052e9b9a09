#pragma once

#include "CompressedFrame.h"
#include "PalpateIOModule.h"

#include <optional>

namespace palpate
{
/// What steers the decoding of a JPEG-LS scan. Names as in ITU-T T.87.
struct JpegLsParameters
{
  int Precision = 0;
  int MaximumValue = 0; ///< MAXVAL
  int Near = 0;         ///< NEAR, the largest error; 0 is lossless
  int Threshold1 = 0;   ///< T1 <= T2 <= T3, of the gradients
  int Threshold2 = 0;
  int Threshold3 = 0;
  int Reset = 64;            ///< RESET
  int Range = 0;             ///< RANGE
  int RangeBits = 0;         ///< qbpp
  int Limit = 0;             ///< LIMIT, of a code's length
  std::size_t ScanStart = 0; ///< place of the first coded byte in the stream
};

/// Reads the markers before the scan and checks them (T.87, C.2). Empty where they are damaged,
/// where they describe another frame than this one (size, depth, one component), and for what the
/// decoder has not: restart intervals, mapping tables, point transforms.
PALPATEIO_EXPORT std::optional<JpegLsParameters> ReadJpegLsParameters(const CompressedFrame& frame);
} // namespace palpate
