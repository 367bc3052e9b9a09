#pragma once

#include "CohortEffects.h"
#include "PalpateGroupModule.h"

#include "vtkPolyData.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// A table of the terms for a console, with its heading.
PALPATEGROUP_EXPORT std::string CohortEffectText(const CohortEffects& effects);

/// Writes effects.csv (one row per term: tests and their p-values), effects.vtp (the mean with all
/// maps as named arrays) and design.csv (the matrix of the model, one row per case) into an
/// existing folder. Throws InputError.
PALPATEGROUP_EXPORT void WriteCohortEffects(const CohortGroup& group, const CohortEffects& effects,
                                            const std::filesystem::path& folder);

///@{ Parts of such files: the maps of ColumnEffect; the area where `p` is below 0.05, mm^2; the
/// matrix of a model.
void AddDisplacementMaps(vtkPolyData* surface, const TermDisplacement& term);
double SignificantArea(const NormalDisplacement& surface, const Eigen::VectorXd& p);
std::string DesignTable(const CohortGroup& group, const LinearDesign& design);
///@}
} // namespace palpate
