#pragma once

#include "Clock.h"
#include "DeviceRegistry.h"
#include "FalconFinder.h"

#include <string>
#include <vector>

namespace palpate
{
/// Every Falcon that is plugged in, with its status; see FalconKind for its argument.
/// Usable ones are opened and queried, by requests without torque, for running firmware and homing;
/// nothing is loaded. `firmwarePath` is the file that would be loaded; empty for none. Fails if
/// there is no Falcon.
Status FindFalcons(FalconFinder& finder, Clock& clock, const std::string& firmwarePath,
                   std::vector<FoundDevice>& found);
} // namespace palpate
