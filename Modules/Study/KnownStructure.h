#pragma once

#include "OrganRelation.h"
#include "PalpateStudyModule.h"
#include "StudyState.h"

namespace palpate
{
/// Whether a structure can be the known organ of a prior: a label, or a model.
PALPATESTUDY_EXPORT bool CanBeKnown(const SceneStructure& structure);

/// The structure that a drawing's prior is given: the chosen one, or by name the only one that has
/// the relation's (as its name or label). Null: none.
PALPATESTUDY_EXPORT const SceneStructure* KnownStructure(const StudyState& state,
                                                         const OrganRelation& relation);

/// The surface of a structure that can be known, as palpate complete --known has it, where it is
/// moved. Throws InputError. Takes about a second for a label, which is fitted.
PALPATESTUDY_EXPORT LogSurface ReadKnownStructure(const SceneStructure& structure,
                                                  LeftHandedAxes leftHanded);
} // namespace palpate
