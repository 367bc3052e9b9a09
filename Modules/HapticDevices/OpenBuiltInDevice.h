#pragma once

#include "Clock.h"
#include "HapticDevice.h"

#include <memory>
#include <string>

namespace palpate
{
/// Creates a closed device of this build by its name ("simulated", "replay:file"). Fails with a
/// message that names the obstacle. The clock must outlive the device.
Status MakeBuiltInDevice(const std::string& name, Clock& clock,
                         std::unique_ptr<HapticDevice>& device);
/// The same, opened. May take seconds.
Status OpenBuiltInDevice(const std::string& name, Clock& clock,
                         std::unique_ptr<HapticDevice>& device);
} // namespace palpate
