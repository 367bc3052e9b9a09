#pragma once

#include "DeviceRegistry.h"

#include <memory>
#include <string>

namespace palpate
{
/// Adds every kind of device of this build. CMake generates the source from the list of back ends.
Status RegisterBuiltInDevices(DeviceRegistry& registry);

/// Takes the ending "+sound" off a device's name. Returns whether it was there: then its touches
/// are to be heard (SoundingDevice).
bool TakeSound(std::string& name);

/// Creates a closed device of this build by its name ("simulated", "replay:file"); "+sound" after
/// it makes its touches heard. Fails with a message that names the obstacle. The clock must outlive
/// the device.
Status MakeBuiltInDevice(const std::string& name, Clock& clock,
                         std::unique_ptr<HapticDevice>& device);
/// The same, opened. May take seconds.
Status OpenBuiltInDevice(const std::string& name, Clock& clock,
                         std::unique_ptr<HapticDevice>& device);
} // namespace palpate
