#pragma once

#include "DeviceCapabilities.h"
#include "PalpateSessionModule.h"
#include "TouchScene.h"

namespace palpate
{
/// Millimetres of a scene for one of a device, so that it reaches round all of it with a little to
/// spare; never below life size.
PALPATESESSION_EXPORT double ReachingScale(const TouchScene& scene,
                                           const DeviceCapabilities& device);
} // namespace palpate
