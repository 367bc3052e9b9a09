#pragma once

#include "DeviceRegistry.h"

namespace palpate
{
/// Adds every kind of device of this build. CMake generates the source from the list of back ends.
Status RegisterBuiltInDevices(DeviceRegistry& registry);
} // namespace palpate
