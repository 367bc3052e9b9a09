#pragma once

#include "Clock.h"
#include "HapticDevice.h"

#include <memory>
#include <string>

namespace palpate
{
/// Makes and opens a device of those that this build has, by its name ("simulated",
/// "replay:file"). May take seconds. Fails with the sentence of what stands in the way. The clock
/// outlives the device.
Status OpenBuiltInDevice(const std::string& name, Clock& clock,
                         std::unique_ptr<HapticDevice>& device);
} // namespace palpate
