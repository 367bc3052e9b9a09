#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// What a MetaImage's header was found to say.
struct MetaImageFacts
{
  std::vector<double> Size; ///< of the three axes
  double VoxelBytes = 0.0;
  std::vector<std::string> Notes; ///< sentences on what was assumed
};

/// Looks at the text header of a MetaImage file before the MetaIO library does, which trusts it: a
/// number of dimensions above ten overruns its arrays, and voxels that are missing stay as the
/// memory was. Throws InputError for a header that is cut off, damaged or read otherwise by the
/// library (see ReadMetaImageFields), 2-D and 4-D images, several values per voxel, spacings that
/// are not positive, data that are shorter than the header says, also behind HeaderSize bytes or as
/// text, and compressed data that end early, fail their checksum or have another length. Notes
/// where the header has no TransformMatrix, so that the axes had to be assumed. An
/// AnatomicalOrientation is not followed, as in ITK: programs disagree on whether its letters say
/// where axes start or end.
PALPATEIO_EXPORT MetaImageFacts CheckMetaImageHeader(const std::filesystem::path& file);
} // namespace palpate
