#include "OpenBuiltInDevice.h"

namespace palpate
{
Status MakeBuiltInDevice(const std::string& name, Clock& clock,
                         std::unique_ptr<HapticDevice>& device)
{
  DeviceRegistry registry;
  const Status status = RegisterBuiltInDevices(registry);
  return status.IsOk() ? registry.Make(name, clock, device) : status;
}

Status OpenBuiltInDevice(const std::string& name, Clock& clock,
                         std::unique_ptr<HapticDevice>& device)
{
  const Status status = MakeBuiltInDevice(name, clock, device);
  return status.IsOk() ? device->Open() : status;
}
} // namespace palpate
