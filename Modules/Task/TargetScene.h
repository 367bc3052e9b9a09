#pragma once

#include "PalpateTaskModule.h"
#include "SceneSettings.h"
#include "TaskSettings.h"

namespace palpate
{
/// Throws InputError unless a target's scene and files have what its kind needs: a mask to be
/// corrected and the true one with the same label; a body to be docked and where it is to be.
PALPATETASK_EXPORT void CheckTarget(TaskKind kind, const TaskTarget& target,
                                    const SceneSettings& scene);
} // namespace palpate
