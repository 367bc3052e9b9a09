#pragma once

#include "DeviceRegistry.h"

namespace palpate
{
/// Adds every kind of device that this build has. The source is written by CMake from the list of
/// back ends.
Status RegisterBuiltInDevices(DeviceRegistry& registry);
} // namespace palpate
