#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// The ending that tells a file's format, in lower case and with its dot: ".nii.gz", ".seg.nrrd",
/// otherwise what follows the last dot. Empty where there is none.
PALPATEIO_EXPORT std::string FileEnding(const std::filesystem::path& path);
} // namespace palpate
