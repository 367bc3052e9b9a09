#pragma once

#include "DeviceRegistry.h"
#include "FalconFinder.h"

#include <memory>

namespace palpate
{
/// Adds "falcon", whose argument is parsed by FalconOptions, with links from `finder`. The kind
/// supports searching for devices, which reports the environment's firmware.
Status AddFalconKind(DeviceRegistry& registry, const std::shared_ptr<FalconFinder>& finder);
} // namespace palpate
