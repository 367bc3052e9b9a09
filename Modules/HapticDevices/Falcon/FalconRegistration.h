#pragma once

#include "DeviceRegistry.h"

namespace palpate
{
/// Adds "falcon": real devices on USB (FalconKind with a LibusbFalconFinder).
Status RegisterFalconDevices(DeviceRegistry& registry);
} // namespace palpate
