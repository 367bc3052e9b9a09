#pragma once

#include "ComparedBody.h"
#include "CorrectedShape.h"
#include "PalpateTaskModule.h"
#include "SceneSettings.h"
#include "TaskConduct.h"
#include "TaskSettings.h"

namespace palpate
{
/// The structure that a mask's target corrects: the scene's first one, a label. Throws InputError
/// if there is none.
PALPATETASK_EXPORT const SceneStructure& CorrectedStructure(const TaskTarget& target,
                                                            const SceneSettings& scene);

/// It as it is before it is corrected. Throws InputError.
PALPATETASK_EXPORT CorrectedShape ReadWrongMask(const TaskTarget& target,
                                                const SceneSettings& scene);

/// The true mask of a target, which has the same label. Throws InputError.
PALPATETASK_EXPORT ComparedBody ReadTrueMask(const TaskTarget& target, const SceneSettings& scene);

/// The answer that a corrected mask is: Dice and mean distance as `palpate compare` has them.
/// Throws InputError, as of a mask without a voxel.
PALPATETASK_EXPORT TaskAnswer MaskAnswer(CorrectedShape& corrected, const ComparedBody& truth);
} // namespace palpate
