#pragma once

#include "DeviceRegistry.h"
#include "FalconFinder.h"

#include <memory>

namespace palpate
{
/// Adds "falcon", whose argument is FalconOptions' text, with links from `finder`. Falcons can be
/// looked for; which firmware would be loaded is then what the environment says.
Status AddFalconKind(DeviceRegistry& registry, const std::shared_ptr<FalconFinder>& finder);
} // namespace palpate
