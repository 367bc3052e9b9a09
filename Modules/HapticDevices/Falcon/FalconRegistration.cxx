#include "FalconRegistration.h"

#include "DeviceArgument.h"
#include "FalconCalibration.h"
#include "FalconDevice.h"
#include "FalconFirmware.h"
#include "FalconSearch.h"
#include "LibusbFalconFinder.h"

#include <cstdlib>
#include <utility>

namespace palpate
{
namespace
{
Status Make(Clock& clock, const std::string& text, std::unique_ptr<HapticDevice>& device)
{
  const DeviceArgument argument = ParseDeviceArgument(text);
  FalconSettings settings;
  settings.FirmwarePath = argument.Firmware;
  const char* const calibration = std::getenv("PALPATE_FALCON_CALIBRATION");
  Status status = calibration != nullptr ? ReadCalibration(calibration, settings.Calibration)
                                         : Status::Success();
  std::unique_ptr<FalconLink> link;
  status = status.IsOk() ? LibusbFalconFinder().MakeLink(argument.Which, link) : status;
  if (status.IsOk())
  {
    device = std::make_unique<FalconDevice>(clock, std::move(link), std::move(settings));
  }
  return status;
}

Status Search(Clock& clock, std::vector<FoundDevice>& found)
{
  LibusbFalconFinder finder;
  return FindFalcons(finder, clock, FalconFirmware::PathOf(""), found);
}
} // namespace

Status RegisterFalconDevices(DeviceRegistry& registry)
{
  return registry.Add("falcon", "a Novint Falcon on USB (falcon:WHICH: by bus path or serial)",
                      Make, Search);
}
} // namespace palpate
