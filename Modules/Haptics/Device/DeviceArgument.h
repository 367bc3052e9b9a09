#pragma once

#include <string>

namespace palpate
{
/// What stands behind a device's name and a colon, for devices that are plugged in: "WHICH",
/// "firmware=FILE" or "WHICH,firmware=FILE". The file's name may hold commas.
struct DeviceArgument
{
  std::string Which;    ///< a place or a serial number; empty for the first one
  std::string Firmware; ///< empty for what is set elsewhere
};

/// Every text is one.
DeviceArgument ParseDeviceArgument(const std::string& text);
/// A device's text ("name" or "name:argument") with this firmware instead of any that it has.
std::string WithFirmware(const std::string& device, const std::string& file);
} // namespace palpate
