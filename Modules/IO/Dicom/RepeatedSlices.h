#pragma once

#include "DicomSeries.h"
#include "PalpateIOModule.h"

#include <string>
#include <vector>

namespace palpate
{
/// A series without slices that are there twice: files at the same position with equal pixels, such
/// as copies and exports that were repeated, of which the first is kept, with a note. Slices of one
/// position whose pixels differ stay, which StackSlices refuses. Throws InputError for pixels that
/// cannot be read.
PALPATEIO_EXPORT DicomSeries WithoutRepeatedSlices(const DicomSeries& series,
                                                   std::vector<std::string>& notes);
} // namespace palpate
