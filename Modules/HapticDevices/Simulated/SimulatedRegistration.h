#pragma once

#include "DeviceRegistry.h"

namespace palpate
{
/// Adds "simulated": a SimulatedDevice as it comes.
Status RegisterSimulatedDevices(DeviceRegistry& registry);
} // namespace palpate
