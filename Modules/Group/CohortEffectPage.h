#pragma once

#include "CohortEffects.h"
#include "PalpateGroupModule.h"

#include <string>

namespace palpate
{
/// How the effects were found, to follow other sentences on methods (plain text).
PALPATEGROUP_EXPORT std::string CohortEffectMethods(const CohortEffects& effects);

/// A section of the cohort's page (HTML): the model in a sentence, a table of its terms, and the
/// mean coloured by the displacement that each term brings (mm), pale where the corrected p-value
/// is 0.05 or more.
PALPATEGROUP_EXPORT std::string CohortEffectSection(const CohortEffects& effects);
} // namespace palpate
