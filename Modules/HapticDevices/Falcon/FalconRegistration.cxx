#include "FalconRegistration.h"

#include "FalconDevice.h"
#include "FalconOptions.h"

#include <string>
#include <utility>

namespace palpate
{
namespace
{
Status MakeFalcon(FalconFinder& finder, Clock& clock, const std::string& argument,
                  std::unique_ptr<HapticDevice>& device)
{
  FalconOptions options;
  FalconSettings settings;
  std::unique_ptr<FalconLink> link;
  Status status = ParseFalconOptions(argument, options);
  if (status.IsOk() && !options.CalibrationPath.empty())
  {
    status = ReadCalibration(options.CalibrationPath, settings.Calibration);
  }
  if (status.IsOk())
  {
    status = finder.MakeLink(options.Device, link);
  }
  if (status.IsOk())
  {
    settings.FirmwarePath = options.FirmwarePath;
    device = std::make_unique<FalconDevice>(clock, std::move(link), std::move(settings));
  }
  return status;
}
} // namespace

Status RegisterFalconDevices(DeviceRegistry& registry, std::shared_ptr<FalconFinder> finder)
{
  return registry.Add("falcon",
                      "a Novint Falcon: falcon:device=<bus path or serial>,firmware=<file>,"
                      "calibration=<file>, each of which may be left out",
                      [finder = std::move(finder)](Clock& clock, const std::string& argument,
                                                   std::unique_ptr<HapticDevice>& device)
                      { return MakeFalcon(*finder, clock, argument, device); });
}
} // namespace palpate
