#pragma once

#include "DeviceRegistry.h"

namespace palpate
{
/// Adds "falcon": a Novint Falcon on USB. Its argument is a DeviceArgument: which one (bus path or
/// serial number) and its firmware, which the environment's PALPATE_FALCON_FIRMWARE names
/// otherwise. PALPATE_FALCON_CALIBRATION may name a calibration file.
Status RegisterFalconDevices(DeviceRegistry& registry);
} // namespace palpate
