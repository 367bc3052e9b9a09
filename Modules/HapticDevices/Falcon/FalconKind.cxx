#include "FalconKind.h"

#include "FalconDevice.h"
#include "FalconFirmware.h"
#include "FalconOptions.h"
#include "FalconSearch.h"

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

Status AddFalconKind(DeviceRegistry& registry, const std::shared_ptr<FalconFinder>& finder)
{
  const auto make =
      [finder](Clock& clock, const std::string& argument, std::unique_ptr<HapticDevice>& device)
  { return MakeFalcon(*finder, clock, argument, device); };
  const auto search = [finder](Clock& clock, std::vector<FoundDevice>& found)
  { return FindFalcons(*finder, clock, FalconFirmware::PathOf(""), found); };
  return registry.Add("falcon",
                      "a Novint Falcon: falcon:device=<bus path or serial>,firmware=<file>,"
                      "calibration=<file>, each of which may be left out",
                      make, search);
}
} // namespace palpate
