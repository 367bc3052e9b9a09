#pragma once

#include "PalpateFitModule.h"
#include "Segmentation.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// Maximum length of a PlainName.
constexpr std::size_t LongestPlainName = 48;

/// Sanitises text for use as the name of a file or folder on every file system: 1 to 48 of the
/// characters A-Z a-z 0-9 - _, with dots inside. Never hidden, "." or "..", a device name on
/// Windows, or with the ending of a file that Palpate writes. A plain name is returned unchanged.
PALPATEFIT_EXPORT std::string PlainName(const std::string& text);

/// The name as compared by case-insensitive file systems.
PALPATEFIT_EXPORT std::string FoldedName(std::string name);

/// A folder name for one case of several: case, label and, if there is one, the structure's name,
/// in at most 80 characters, otherwise as a PlainName; for a surface, which has no label, the case
/// alone. Different for each structure of a case.
PALPATEFIT_EXPORT std::string CaseFolderName(const std::string& caseName, const Segment& structure);

/// "1" or "1_Prostate": a structure's folder within its case's.
PALPATEFIT_EXPORT std::string StructureFolderName(const Segment& structure);
} // namespace palpate
