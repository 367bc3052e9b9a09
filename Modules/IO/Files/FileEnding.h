#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// The file ending that states the format, in lower case and with its dot: ".nii.gz", ".seg.nrrd",
/// otherwise from the last dot on. Empty if there is none.
PALPATEIO_EXPORT std::string FileEnding(const std::filesystem::path& path);
} // namespace palpate
