#pragma once

#include "DeviceCapabilities.h"
#include "PalpateSessionModule.h"

#include <string>
#include <vector>

namespace palpate
{
/// A kind of device that this build knows, and how it is.
struct DeviceReport
{
  std::string Name; ///< by which it is asked for
  std::string Description;
  bool IsThere = false;
  DeviceCapabilities Capabilities; ///< where it is there
  std::string Says;                ///< its state, or what stands in the way
};

/// Every kind, each opened and closed again.
PALPATESESSION_EXPORT std::vector<DeviceReport> ListDevices();
} // namespace palpate
