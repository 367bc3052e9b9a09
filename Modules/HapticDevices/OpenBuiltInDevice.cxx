#include "OpenBuiltInDevice.h"

#include "SoundingDevice.h"

#include <utility>

namespace palpate
{
bool TakeSound(std::string& name)
{
  const std::string ending = "+sound";
  const bool sounds = name.size() > ending.size() &&
                      name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
  name.resize(name.size() - (sounds ? ending.size() : 0));
  return sounds;
}

Status MakeBuiltInDevice(const std::string& name, Clock& clock,
                         std::unique_ptr<HapticDevice>& device)
{
  std::string silent = name;
  const bool sounds = TakeSound(silent);
  DeviceRegistry registry;
  Status status = RegisterBuiltInDevices(registry);
  if (status.IsOk())
  {
    status = registry.Make(silent, clock, device);
  }
  if (status.IsOk() && sounds)
  {
    device = std::make_unique<SoundingDevice>(std::move(device));
  }
  return status;
}

Status OpenBuiltInDevice(const std::string& name, Clock& clock,
                         std::unique_ptr<HapticDevice>& device)
{
  const Status status = MakeBuiltInDevice(name, clock, device);
  return status.IsOk() ? device->Open() : status;
}
} // namespace palpate
