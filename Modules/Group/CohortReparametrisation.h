#pragma once

#include "CohortGroup.h"
#include "GroupReparametrisation.h"
#include "KernelProgress.h"
#include "PalpateGroupModule.h"
#include "ShapeModelQuality.h"

#include <string>

namespace palpate
{
class ReportPage;

/// How the parameters of a group's cases were moved to suit the group.
struct CohortReparametrisation
{
  ReparametrisationSettings Settings;
  ReparametrisationResult Result; ///< without the surfaces, which the group has
  ShapeModelQuality Before;       ///< of the group's modes with the given parameters
  ShapeModelQuality After;
};

/// Moves the parameters of the group's surface models (ReparametriseGroup). The group's models and
/// modes change. Throws InputError for radial models and for fewer than three cases, and Cancelled
/// if `progress` cancels.
PALPATEGROUP_EXPORT CohortReparametrisation ReparametriseCohortGroup(
    CohortGroup& group, const RandomShapeSettings& random, const KernelProgress& progress = {});

/// One row per case: whether its parameters moved, by how much (deg), the least ratio of areas on
/// the parameter sphere, and by how much the surface changed (mm), as CSV.
PALPATEGROUP_EXPORT std::string
ReparametrisationTable(const CohortGroup& group, const CohortReparametrisation& reparametrisation);

/// What was done, in sentences for a publication.
PALPATEGROUP_EXPORT std::string
ReparametrisationText(const CohortReparametrisation& reparametrisation);

/// Adds the part of the page.
PALPATEGROUP_EXPORT void AddReparametrisation(ReportPage& page,
                                              const CohortReparametrisation& reparametrisation);
} // namespace palpate
