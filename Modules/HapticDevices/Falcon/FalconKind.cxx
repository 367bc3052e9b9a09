#include "FalconKind.h"

#include "FalconDevice.h"
#include "FalconFirmware.h"
#include "FalconSearch.h"

#include <sstream>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
struct FalconOptions
{
  std::string Device;          // bus path or serial; empty: the first usable one
  std::string FirmwarePath;    // empty: the environment's (FalconFirmware::PathOf)
  std::string CalibrationPath; // empty: the published values
};

// Parses the text after "falcon:"; empty text gives the defaults.
Status ParseFalconOptions(const std::string& text, FalconOptions& options)
{
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');)
  {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    std::string* const value = name == "device"        ? &options.Device
                               : name == "firmware"    ? &options.FirmwarePath
                               : name == "calibration" ? &options.CalibrationPath
                                                       : nullptr;
    if (value == nullptr || equals == std::string::npos || equals + 1 == word.size())
    {
      return Status::Failure("\"" + word +
                             "\" is not understood: a Falcon takes device=, "
                             "firmware= and calibration=, separated by commas.");
    }
    *value = word.substr(equals + 1);
  }
  return Status::Success();
}

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
                      make, search, DeviceRegistry::Proof::UntriedOnHardware);
}
} // namespace palpate
