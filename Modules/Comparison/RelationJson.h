#pragma once

#include "OrganRelations.h"
#include "PalpateComparisonModule.h"

#include <string>

namespace palpate
{
/// One object, as Documentation/JsonOutput.md lists its keys; `folder` is where files are written,
/// or empty.
PALPATECOMPARISON_EXPORT std::string RelationJson(const OrganRelations& relations,
                                                  const std::string& folder);
} // namespace palpate
