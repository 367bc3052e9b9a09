#pragma once

#include "Clock.h"
#include "HapticDevice.h"

#include <memory>
#include <string>

namespace palpate
{
/// Makes a device of those that this build has, closed, by its name ("simulated", "replay:file").
/// Fails with the sentence of what stands in the way. The clock outlives the device.
Status MakeBuiltInDevice(const std::string& name, Clock& clock,
                         std::unique_ptr<HapticDevice>& device);
/// The same, opened. May take seconds.
Status OpenBuiltInDevice(const std::string& name, Clock& clock,
                         std::unique_ptr<HapticDevice>& device);
} // namespace palpate
