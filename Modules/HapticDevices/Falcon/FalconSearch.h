#pragma once

#include "Clock.h"
#include "DeviceRegistry.h"
#include "FalconFinder.h"

#include <string>
#include <vector>

namespace palpate
{
/// Every Falcon that is plugged in and how it is; its argument is FalconOptions' text. Those that
/// can be had are opened and asked, by requests without torque, whether firmware runs and whether
/// it is homed; nothing is loaded. `firmwarePath` is what would be; empty for none. Fails where
/// there is no Falcon.
Status FindFalcons(FalconFinder& finder, Clock& clock, const std::string& firmwarePath,
                   std::vector<FoundDevice>& found);
} // namespace palpate
