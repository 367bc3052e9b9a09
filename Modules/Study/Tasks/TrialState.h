#pragma once

#include "PalpateStudyModule.h"
#include "StudyState.h"
#include "TaskSettings.h"

#include <string>

namespace palpate
{
/// The study of a trial: `first` with the target's scene in a condition, touched with `device`
/// unless the scene names another one than the simulated one. What would tell the answer is not
/// shown: in a search for a nodule, what is not touched. A mask is under correction. Reads the
/// scene and the segmentations that it names; throws InputError, also as CheckTarget does.
PALPATESTUDY_EXPORT StudyState TrialState(const StudyState& first, const std::string& device,
                                          TaskKind kind, const TaskTarget& target,
                                          const TaskCondition& condition);
} // namespace palpate
