#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
struct MetaImageFacts
{
  std::vector<double> Size; ///< of the three axes
  double VoxelBytes = 0.0;
  double MillimetersPerUnit = 1.0; ///< of DistanceUnits, which the library ignores
  bool IsOriented = true;          ///< false without a TransformMatrix
  std::vector<std::string> Notes;  ///< on its orientation and unit, as sentences
};

/// Checks the text header of a MetaImage file before the MetaIO library reads it, since the library
/// trusts it: more than ten dimensions overrun its arrays, and missing voxels are left
/// uninitialized. Throws InputError for a header that is truncated, damaged or read differently by
/// the library (see ReadMetaImageFields), 2-D and 4-D images, several values per voxel, spacings
/// that are not positive, data shorter than declared (also after HeaderSize bytes or as text), and
/// compressed data that end early, fail their checksum or have another length. A header without
/// TransformMatrix gives a note on the assumed axes. AnatomicalOrientation is ignored, as in ITK:
/// programs disagree on whether its letters state where axes start or end.
PALPATEIO_EXPORT MetaImageFacts CheckMetaImageHeader(const std::filesystem::path& file);
} // namespace palpate
