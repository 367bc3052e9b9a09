#pragma once

#include "CohortGroup.h"
#include "CohortTable.h"
#include "PalpateGroupModule.h"

#include <filesystem>

namespace palpate
{
/// Writes what a group of models in the patients' axes says of an organ before it is touched
/// (ShapePrior::OfGroup of radial models, SurfacePrior::OfGroup of surface models;
/// WriteShapePrior), and notes the cases that are omitted. `known`, of models relative to its
/// `knownFolder`, has another organ of the same cases, to which a prior of surface models then
/// relates, with its name; an empty table: none. No case is named in the file. Throws InputError
/// for other axes, fewer than three usable cases, and a known organ for radial models.
PALPATEGROUP_EXPORT void WriteCohortPrior(CohortGroup& group, const CohortTable& known,
                                          const std::filesystem::path& knownFolder,
                                          const std::filesystem::path& file);
} // namespace palpate
