#pragma once

#include "PalpateSessionModule.h"
#include "ScenePlan.h"
#include "StudyState.h"

#include <vector>

namespace palpate
{
/// The stamps of all files that a state names.
PALPATESESSION_EXPORT SceneStamps StampFiles(const StudyState& state);

/// Everything that a state needs: its scene, and the volume and the segmentation of its slices.
PALPATESESSION_EXPORT std::vector<SceneNode>
PlanStudy(const StudyState& state, const SceneStamps& stamps, const SceneLookup& lookup);
} // namespace palpate
