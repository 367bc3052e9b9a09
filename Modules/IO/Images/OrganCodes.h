#pragma once

#include "PalpateIOModule.h"
#include "SegmentCodes.h"

#include <string>

namespace palpate
{
/// SNOMED CT's codes of a structure by its English name, such as "Liver" or "kidney_left", whatever
/// its case and separators; those of Tissue for any other name.
/// Source: DICOM PS3.16, CID 7150, 7166 and 244.
PALPATEIO_EXPORT SegmentCodes CodesOfName(const std::string& name);
} // namespace palpate
