#pragma once

#include "DeviceRegistry.h"
#include "FalconFinder.h"

#include <memory>

namespace palpate
{
/// Adds "falcon" with links from `finder`. Its argument are options, separated by commas, in any
/// order:
///
///     falcon:device=1-2.3,firmware=/home/me/firmware.bin,calibration=/home/me/falcon.txt
///
/// The kind supports searching for devices, which reports the environment's firmware.
Status AddFalconKind(DeviceRegistry& registry, const std::shared_ptr<FalconFinder>& finder);
} // namespace palpate
