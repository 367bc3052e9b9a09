#pragma once

#include "CohortGroup.h"
#include "KernelProgress.h"
#include "PalpateGroupModule.h"
#include "ParameterCorrespondence.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{
/// How well the parameters of a case correspond to those of the other cases.
struct CorrespondingCase
{
  std::size_t Row = 0; ///< of the group
  ParameterCorrespondence Found;
  bool IsOutlier = false; ///< its distance is beyond the fence
};

/// The correspondence of all cases of a group.
struct CohortCorrespondence
{
  std::vector<CorrespondingCase> Cases; ///< the farthest from the others first
  double Fence = 0.0;                   ///< of the distances, mm (UpperLogFence)
};

/// Compares each case of a group with the mean of all others at equal parameters
/// (CompareParameters). Flipped cases and outliers get a note. No cases if the group has fewer than
/// three. Throws Cancelled.
PALPATEGROUP_EXPORT CohortCorrespondence FindCohortCorrespondence(CohortGroup& group,
                                                                  const KernelProgress& progress);

/// One row per case, the farthest first, as CSV: distances (mm), their ratio, the other orientation
/// and its angle (deg), and whether it is flipped or an outlier.
PALPATEGROUP_EXPORT std::string CorrespondenceTable(const CohortGroup& group,
                                                    const CohortCorrespondence& correspondence);
} // namespace palpate
