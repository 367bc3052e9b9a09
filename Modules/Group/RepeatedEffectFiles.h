#pragma once

#include "PalpateGroupModule.h"
#include "RepeatedEffects.h"

#include <filesystem>
#include <string>

namespace palpate
{
class ReportPage;

/// A table of the terms for a console, with its heading.
PALPATEGROUP_EXPORT std::string RepeatedEffectText(const RepeatedEffects& effects);
/// How the effects were found, to follow other sentences on methods (plain text).
PALPATEGROUP_EXPORT std::string RepeatedEffectMethods(const RepeatedEffects& effects);
/// Adds the model in a sentence, tables, and the mean coloured by the displacement that each term
/// brings (mm), pale where the false-discovery rate is 0.05 or more.
PALPATEGROUP_EXPORT void AddRepeatedEffects(ReportPage& page, const RepeatedEffects& effects);

/// Writes repeated.csv (one row per figure and coefficient), repeated_variances.csv (one row per
/// figure), effects.csv (one row per term at the points), effects.vtp (the mean with all maps as
/// named arrays) and design.csv into an existing folder. Throws InputError.
PALPATEGROUP_EXPORT void WriteRepeatedEffects(const CohortGroup& group,
                                              const RepeatedEffects& effects,
                                              const std::filesystem::path& folder);
} // namespace palpate
