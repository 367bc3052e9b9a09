#pragma once

#include "NiftiOrientation.h"
#include "PalpateIOModule.h"

#include <filesystem>

namespace palpate
{
/// Looks at the header of a NIfTI-1 file before the NIfTI library does, which repairs what should
/// be refused: a spacing of zero becomes 1 there. Throws InputError for a header that is cut off or
/// damaged, NIfTI-2, colour or complex voxels, 2-D and 4-D images, spacings that are not positive,
/// and an uncompressed file that is shorter than its header says. Returns the orientation that the
/// header gives.
/// Source: nifti1.h, https://nifti.nimh.nih.gov/nifti-1.
PALPATEIO_EXPORT NiftiOrientation CheckNiftiHeader(const std::filesystem::path& file);
} // namespace palpate
