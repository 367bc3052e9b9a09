#pragma once

#include "CheckedCase.h"
#include "Segmentation.h"

namespace palpate
{
/// Appends to each organ "overlap": the largest share of the smaller of two structures that is in
/// both, unless that is more than nine tenths (a part of an organ may be a structure of its own);
/// Amount: mm^3. Organs are those of the segments, in their order; layers have one grid.
void AddOverlaps(const Segmentation& labels, CheckedCase& patient);
} // namespace palpate
