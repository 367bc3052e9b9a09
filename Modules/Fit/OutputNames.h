#pragma once

#include "PalpateFitModule.h"
#include "Segmentation.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// The most letters of a PlainName.
constexpr std::size_t LongestPlainName = 48;

/// Sanitises text for use as the name of a file or folder on every file system: 1 to 48 of the
/// letters A-Z a-z 0-9 - _ and dots within them. Never hidden, "." or "..", a device's name on
/// Windows, or ended like a file that Palpate writes. A plain name comes back as it is.
PALPATEFIT_EXPORT std::string PlainName(const std::string& text);

/// The name as file systems compare it that do not tell capital letters apart.
PALPATEFIT_EXPORT std::string FoldedName(std::string name);

/// A folder name for one case of several: case, label and, if there is one, the structure's name,
/// in at most 80 letters, otherwise as a PlainName. Structures of one case differ in it.
PALPATEFIT_EXPORT std::string CaseFolderName(const std::string& caseName, const Segment& structure);

/// "1" or "1_Prostate": a structure's folder within its case's.
PALPATEFIT_EXPORT std::string StructureFolderName(const Segment& structure);
} // namespace palpate
