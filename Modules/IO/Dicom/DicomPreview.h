#pragma once

#include "DicomSeries.h"
#include "PalpateIOModule.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// A small picture of a slice, row by row from the top; empty if there is none.
struct DicomPreview
{
  int Width = 0;
  int Height = 0;
  std::vector<std::uint8_t> Grey;
};

/// The middle slice of a series in its proportions, at most `side` pixels wide and high; black and
/// white are its percentiles 1 and 99. Empty if its pixels cannot be read. Reads no other slice.
PALPATEIO_EXPORT DicomPreview ReadDicomPreview(const DicomSeries& series, int side);
} // namespace palpate
