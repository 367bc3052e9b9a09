#pragma once

#include "CohortGroup.h"
#include "PalpateGroupModule.h"

#include <filesystem>

namespace palpate
{
/// Writes what a group of radial models in the patients' axes says of an organ before it is touched
/// (ShapePrior::OfGroup, WriteShapePrior), and notes the cases that are omitted. No case is named
/// in the file. Throws InputError for surface models, other axes, and fewer than three usable
/// cases.
PALPATEGROUP_EXPORT void WriteCohortPrior(CohortGroup& group, const std::filesystem::path& file);
} // namespace palpate
