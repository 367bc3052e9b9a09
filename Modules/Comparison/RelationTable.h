#pragma once

#include "OrganRelations.h"
#include "PalpateComparisonModule.h"

#include <string>

namespace palpate
{
///@{ CSV with a head and a row for each organ or pair; keys as in JSON, with a unit at the end.
PALPATECOMPARISON_EXPORT std::string OrganTable(const OrganRelations& relations);
PALPATECOMPARISON_EXPORT std::string OrganPairTable(const OrganRelations& relations);
///@}

/// CSV with a row for each section of a tube.
PALPATECOMPARISON_EXPORT std::string CalibreTable(const Calibre& tube);

/// A feature's key with its unit: "volume_mesh_mm3", "elongation".
PALPATECOMPARISON_EXPORT std::string KeyWithUnit(const ShapeFeature& feature);
} // namespace palpate
