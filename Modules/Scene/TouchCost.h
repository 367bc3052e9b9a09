#pragma once

#include "Clock.h"
#include "PalpateSceneModule.h"
#include "Progress.h"
#include "SceneSettings.h"
#include "TouchContact.h"

#include <cstddef>

namespace palpate
{
/// What a structure costs each tick of the servo that feels it.
struct TouchCost
{
  double MedianNanoseconds = 0.0;
  std::size_t Ticks = 0; ///< that were timed, each while the tool touched
};

/// Presses the tool into the structure here and there, as a hand would at 1 kHz, and times each
/// tick beside whatever else this machine does. Throws InputError where the tool cannot touch it,
/// and Cancelled.
PALPATESCENE_EXPORT TouchCost MeasureTouchCost(const TouchContact& contact,
                                               const TouchToolSettings& tool, const Clock& clock,
                                               const ProgressFunction& progress);
} // namespace palpate
