#pragma once

#include "PalpateStudyModule.h"
#include "ScenePlan.h"
#include "StudyState.h"

#include <vector>

namespace palpate
{
/// The stamps of all files that a state names.
PALPATESTUDY_EXPORT SceneStamps StampFiles(const StudyState& state);

/// All nodes that a state needs: those of its scene, and the volume and segmentation of its slices.
PALPATESTUDY_EXPORT std::vector<SceneNode>
PlanStudy(const StudyState& state, const SceneStamps& stamps, const SceneLookup& lookup);
} // namespace palpate
