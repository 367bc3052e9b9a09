#include "DeviceList.h"

#include "BuiltInDevices.h"
#include "SteadyClock.h"

#include <stdexcept>

namespace palpate
{
namespace
{
void Ask(const DeviceRegistry& registry, Clock& clock, DeviceReport& report)
{
  std::unique_ptr<HapticDevice> device;
  Status status = registry.Make(report.Name, clock, device);
  if (status.IsOk())
  {
    status = device->Open();
    report.IsThere = status.IsOk();
  }
  if (!status.IsOk())
  {
    report.Says = status.Message();
    return;
  }
  report.Capabilities = device->Capabilities();
  report.Says = NameOf(device->State());
  device->Close();
}
} // namespace

std::vector<DeviceReport> ListDevices()
{
  DeviceRegistry registry;
  const Status status = RegisterBuiltInDevices(registry);
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  SteadyClock clock;
  std::vector<DeviceReport> reports;
  for (const std::string& name : registry.Names())
  {
    DeviceReport report;
    report.Name = name;
    report.Description = registry.Description(name);
    Ask(registry, clock, report);
    reports.push_back(std::move(report));
  }
  return reports;
}
} // namespace palpate
