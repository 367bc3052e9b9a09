#pragma once

#include "CohortGroup.h"
#include "PalpateGroupModule.h"

#include <string>
#include <vector>

namespace palpate
{
/// Adds notes of one kind to those of a group: one each for a few cases, one for all of many, which
/// names the first and, after "other cases", says `ofMany`, and the `table` with all of them.
PALPATEGROUP_EXPORT void AddCohortNotes(const std::vector<CohortNote>& notes,
                                        const std::string& ofMany, const std::string& table,
                                        CohortGroup& group);
} // namespace palpate
