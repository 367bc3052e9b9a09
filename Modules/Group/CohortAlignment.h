#pragma once

#include "CohortGroup.h"
#include "KernelProgress.h"
#include "PalpateGroupModule.h"
#include "ProcrustesAlignment.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// How the cases of a group were turned to their mean.
struct CohortAlignment
{
  std::vector<ProcrustesCase> Cases; ///< one per row of the group
  bool IsScaled = false;
  std::string
      Reference; ///< name of the file with the shape to which cases were turned; may be empty
  int Rounds = 0;
};

/// Turns the models of a group that are in the patients' axes to their mean (AlignByProcrustes), or
/// to the model in the file `reference` if that is not empty; with `isScaled` all get one size. The
/// group's models and modes change, its axes become Procrustes, and cases whose orientation is
/// ambiguous or that look mirrored get a note. Throws InputError, and Cancelled if `progress`
/// cancels.
PALPATEGROUP_EXPORT CohortAlignment AlignCohortGroup(CohortGroup& group, bool isScaled,
                                                     const std::filesystem::path& reference,
                                                     const KernelProgress& progress = {});

/// One row per case: the angle of its turn (deg), scale, and residuals (mm) of the orientation, of
/// the best half turn and of the mirror image, as CSV.
PALPATEGROUP_EXPORT std::string AlignmentTable(const CohortGroup& group,
                                               const CohortAlignment& alignment);

/// What was done, as a sentence.
PALPATEGROUP_EXPORT std::string AlignmentText(const CohortAlignment& alignment);
} // namespace palpate
