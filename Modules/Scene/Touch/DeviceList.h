#pragma once

#include "DeviceCapabilities.h"
#include "PalpateSceneModule.h"

#include <string>
#include <vector>

namespace palpate
{
/// A kind of device that this build supports, or one device of a kind, with its state.
struct DeviceReport
{
  std::string Name; ///< "kind" or "kind:which", as in options and files
  std::string Description;
  bool IsThere = false;
  bool IsUntried = false;          ///< its back end, on hardware
  DeviceCapabilities Capabilities; ///< if it is there
  std::string Details;             ///< its state, or why it cannot be used
};

/// Lists every kind. If devices of a kind can be searched for, each one that is plugged in, without
/// opening it; of other kinds, one device is opened and closed again.
/// A kind that is `inUse` (as in options) is not asked, since that could disturb it.
PALPATESCENE_EXPORT std::vector<DeviceReport> ListDevices(const std::string& inUse = {});
/// The same of one kind, by its name; empty if it is not known.
PALPATESCENE_EXPORT std::vector<DeviceReport> ListDevicesOf(const std::string& kind);
/// One line: that it can be used, or what is missing and what to do.
PALPATESCENE_EXPORT std::string StateLine(const DeviceReport& report);
/// What devices of this name are like before they are opened; nothing is searched for. Without
/// buttons for a name that is not known.
PALPATESCENE_EXPORT DeviceCapabilities UsualCapabilities(const std::string& device);

/// The name of the first device that is plugged in and usable as it is; if none is usable, the
/// first one, which reports what is missing when opened. Throws InputError if no device is plugged
/// in.
PALPATESCENE_EXPORT std::string FirstDevicePluggedIn();
/// Whether devices of this name are hardware, so that they run in real time; replayed and simulated
/// ones may run in virtual time.
PALPATESCENE_EXPORT bool IsPluggedIn(const std::string& device);
} // namespace palpate
