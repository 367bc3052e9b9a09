#pragma once

#include "DeviceCapabilities.h"
#include "PalpateSceneModule.h"

#include <string>
#include <vector>

namespace palpate
{
/// A kind of device that this build knows, or one device of a kind, and how it is.
struct DeviceReport
{
  std::string Name; ///< by which it is asked for: "kind" or "kind:which"
  std::string Description;
  bool IsThere = false;
  DeviceCapabilities Capabilities; ///< where it is there
  std::string Says;                ///< its state, or what stands in the way
};

/// Every kind. Where devices of a kind can be looked for, each of them that is plugged in, as it
/// stands; of the others, one is opened and closed again.
PALPATESCENE_EXPORT std::vector<DeviceReport> ListDevices();

/// The name of the first device that is plugged in and can be used as it stands; where none can,
/// of the first, whose opening says what is missing. Throws InputError where there is none.
PALPATESCENE_EXPORT std::string FirstDevicePluggedIn();
/// Whether devices of this name are plugged in, so that their time is the real one; replayed and
/// computed ones have any.
PALPATESCENE_EXPORT bool IsPluggedIn(const std::string& device);
} // namespace palpate
