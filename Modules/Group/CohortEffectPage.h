#pragma once

#include "CohortEffects.h"
#include "PalpateGroupModule.h"

#include <string>

namespace palpate
{
class ReportPage;

/// How the effects were found, to follow other sentences on methods (plain text).
PALPATEGROUP_EXPORT std::string CohortEffectMethods(const CohortEffects& effects);

/// Adds the model in a sentence, a table of its terms, and the mean coloured by the displacement
/// that each term brings (mm), pale where the corrected p-value is 0.05 or more.
PALPATEGROUP_EXPORT void AddCohortEffects(ReportPage& page, const CohortEffects& effects);

///@{ Parts of such a section: the mean coloured by a map (mm) or by a term, pale where `p` is 0.05
/// or more; cases
/// that are omitted, and terms that others inflate.
void AddMapFigures(ReportPage& page, const std::string& title, const Eigen::VectorXd& map,
                   double limit, const Eigen::VectorXd& p, const NormalDisplacement& surface);
void AddDisplacementFigures(ReportPage& page, const TermDisplacement& effect,
                            const Eigen::VectorXd& p, const NormalDisplacement& surface);
void AddDesignNotes(ReportPage& page, const LinearDesign& design);
///@}
} // namespace palpate
