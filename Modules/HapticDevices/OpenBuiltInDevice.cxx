#include "OpenBuiltInDevice.h"

#include "BuiltInDevices.h"

namespace palpate
{
Status OpenBuiltInDevice(const std::string& name, Clock& clock,
                         std::unique_ptr<HapticDevice>& device)
{
  DeviceRegistry registry;
  Status status = RegisterBuiltInDevices(registry);
  if (status.IsOk())
  {
    status = registry.Make(name, clock, device);
  }
  return status.IsOk() ? device->Open() : status;
}
} // namespace palpate
