#include "DeviceArgument.h"

namespace palpate
{
namespace
{
const std::string FirmwareKey = "firmware=";
}

DeviceArgument ParseDeviceArgument(const std::string& text)
{
  if (text.rfind(FirmwareKey, 0) == 0)
  {
    return {"", text.substr(FirmwareKey.size())};
  }
  const std::size_t comma = text.find("," + FirmwareKey);
  return comma == std::string::npos
             ? DeviceArgument{text, ""}
             : DeviceArgument{text.substr(0, comma), text.substr(comma + 1 + FirmwareKey.size())};
}

std::string WithFirmware(const std::string& device, const std::string& file)
{
  const std::size_t colon = device.find(':');
  const std::string which =
      colon == std::string::npos ? "" : ParseDeviceArgument(device.substr(colon + 1)).Which;
  return device.substr(0, colon) + ":" + which + (which.empty() ? "" : ",") + FirmwareKey + file;
}
} // namespace palpate
