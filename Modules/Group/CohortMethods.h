#pragma once

#include "CohortGroup.h"
#include "PalpateGroupModule.h"

#include <string>
#include <vector>

namespace palpate
{
/// What was done to a group, with versions and settings, in sentences for a publication (plain
/// text, a paragraph each). There are no paths and no names of cases in it: of a model file's
/// provenance only known settings and plain values are taken. `program` is what made the group.
PALPATEGROUP_EXPORT std::vector<std::string>
CohortMethods(const CohortGroup& group, const CohortOutput& output, const std::string& program);

/// How the axes of the cases were chosen, to follow "axes are".
PALPATEGROUP_EXPORT std::string CohortAxesText(const CohortGroup& group,
                                               const CohortOutput& output);
} // namespace palpate
