#pragma once

#include "Clock.h"
#include "PalpateSceneModule.h"
#include "Progress.h"
#include "SceneSettings.h"
#include "TouchContact.h"

#include <cstddef>

namespace palpate
{
/// Time that a structure takes in each servo tick.
struct TouchCost
{
  double MedianNanoseconds = 0.0;
  std::size_t Ticks = 0; ///< timed ticks, all of them in contact
};

/// Presses the tool into the structure at several places, as a hand would at 1 kHz, and times each
/// tick under the machine's current load. Throws InputError if the tool cannot touch it, and
/// Cancelled.
PALPATESCENE_EXPORT TouchCost MeasureTouchCost(const TouchContact& contact,
                                               const TouchToolSettings& tool, const Clock& clock,
                                               const ProgressFunction& progress);
} // namespace palpate
