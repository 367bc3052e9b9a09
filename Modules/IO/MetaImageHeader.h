#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Looks at the text header of a MetaImage file before the MetaIO library does, which trusts it: a
/// number of dimensions above ten overruns its arrays. Throws InputError for a header that is cut
/// off or damaged, 2-D and 4-D images, several values per voxel, spacings that are not positive,
/// data that are shorter than the header says, and compressed data that end early, fail their
/// checksum or have another length: the library fills up what it misses. Returns a sentence where
/// the header has no TransformMatrix, so that the axes had to be assumed. An AnatomicalOrientation
/// is not followed, as in ITK: programs disagree on whether its letters say where axes start or
/// end.
PALPATEIO_EXPORT std::vector<std::string> CheckMetaImageHeader(const std::filesystem::path& file);
} // namespace palpate
