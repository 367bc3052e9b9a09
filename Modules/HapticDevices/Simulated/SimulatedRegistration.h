#pragma once

#include "DeviceRegistry.h"

namespace palpate
{
/// Adds "simulated": a SimulatedDevice with default settings.
Status RegisterSimulatedDevices(DeviceRegistry& registry);
} // namespace palpate
