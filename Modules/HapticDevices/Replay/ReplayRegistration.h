#pragma once

#include "DeviceRegistry.h"

namespace palpate
{
/// Adds "replay:<file>": a ReplayDevice of a recorded session.
Status RegisterReplayDevices(DeviceRegistry& registry);
} // namespace palpate
