#pragma once

#include "CohortGroup.h"
#include "Covariates.h"
#include "ModelFormula.h"
#include "PalpateGroupModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// For several scans of a patient, which are not independent: repeated.csv with the scores of the
/// first modes (mm, at most 10) and the covariates, and repeated.R, which fits a linear model with
/// a random intercept for each value of the column `patient` to each mode, by restricted maximum
/// likelihood (Patterson and Thompson, Biometrika 58, 1971). It needs no package of R; degrees of
/// freedom are those of terms that vary within or only between patients. Throws InputError if there
/// is no such column or a file cannot be written.
PALPATEGROUP_EXPORT void WriteRepeatedScans(const CohortGroup& group,
                                            const CovariateTable& covariates,
                                            const ModelFormula& formula, const std::string& patient,
                                            const std::filesystem::path& folder);
} // namespace palpate
