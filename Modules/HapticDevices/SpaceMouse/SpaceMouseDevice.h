#pragma once

#include "DeviceRegistry.h"

namespace palpate
{
/// Adds "spacemouse" and "spacemouse:SOCKET": a computed hand that a six-axis cap steers.
Status RegisterSpaceMouseDevices(DeviceRegistry& registry);
} // namespace palpate
