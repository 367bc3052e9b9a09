#pragma once

#include "CohortQuality.h"
#include "PalpateGroupModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// The files of WriteCohortQuality.
PALPATEGROUP_EXPORT std::vector<std::string> CohortQualityNames();

/// Writes model_quality.csv (one row per number of modes, from 0: compactness, mm^2, as a share of
/// the variance, generalisation and specificity, mm, with standard errors), distances.csv (one row
/// per case, the most unusual first) and distances.vtp (the mean with the standard deviation at
/// each point, mm, and a map for each of the most unusual cases) into an existing folder. Throws
/// InputError.
PALPATEGROUP_EXPORT void WriteCohortQuality(const CohortGroup& group, const CohortQuality& quality,
                                            const std::filesystem::path& folder);
} // namespace palpate
