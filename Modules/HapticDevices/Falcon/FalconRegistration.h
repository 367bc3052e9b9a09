#pragma once

#include "DeviceRegistry.h"
#include "FalconFinder.h"

#include <memory>

namespace palpate
{
/// Adds "falcon", whose argument is FalconOptions' text, with links from `finder`.
Status RegisterFalconDevices(DeviceRegistry& registry, std::shared_ptr<FalconFinder> finder);
} // namespace palpate
