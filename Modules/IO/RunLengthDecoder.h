#pragma once

#include "CompressedFrame.h"
#include "PalpateIOModule.h"

namespace palpate
{
/// Decodes DICOM's run-length coding (PS3.5, annex G) into `pixels`, which has room for the frame.
/// False where the stream does not hold every pixel. DCMTK's own decoder fills what is missing and
/// calls that success.
[[nodiscard]] PALPATEIO_EXPORT bool DecodeRunLength(const CompressedFrame& frame,
                                                    std::uint8_t* pixels);
} // namespace palpate
