#include "DeviceList.h"

#include "InputError.h"
#include "OpenBuiltInDevice.h"
#include "SteadyClock.h"

#include <stdexcept>

namespace palpate
{
namespace
{
// Opens a device, and closes it again.
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
    report.Details = status.Message();
    return;
  }
  report.Capabilities = device->Capabilities();
  report.Details = NameOf(device->State());
  device->Close();
}

// One report per plugged-in device; if there is none, one report that says so.
void Find(const DeviceRegistry& registry, Clock& clock, const DeviceReport& kind,
          std::vector<DeviceReport>& reports)
{
  std::vector<FoundDevice> found;
  const Status status = registry.FindDevices(kind.Name, clock, found);
  if (!status.IsOk())
  {
    reports.push_back(kind);
    reports.back().Details = status.Message();
  }
  for (const FoundDevice& one : found)
  {
    DeviceReport report = kind;
    report.Name += ":" + one.Argument;
    report.Details = one.Details;
    std::unique_ptr<HapticDevice> device;
    report.IsThere = one.IsUsable && registry.Make(report.Name, clock, device).IsOk();
    if (report.IsThere)
    {
      report.Capabilities = device->Capabilities();
    }
    reports.push_back(std::move(report));
  }
}

DeviceRegistry Registry()
{
  DeviceRegistry registry;
  const Status status = RegisterBuiltInDevices(registry);
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  return registry;
}
} // namespace

std::vector<DeviceReport> ListDevices()
{
  const DeviceRegistry registry = Registry();
  SteadyClock clock;
  std::vector<DeviceReport> reports;
  for (const std::string& name : registry.Names())
  {
    DeviceReport report;
    report.Name = name;
    report.Description = registry.Description(name);
    if (registry.CanBeFound(name))
    {
      Find(registry, clock, report, reports);
      continue;
    }
    Ask(registry, clock, report);
    reports.push_back(std::move(report));
  }
  return reports;
}

std::string FirstDevicePluggedIn()
{
  const DeviceRegistry registry = Registry();
  SteadyClock clock;
  std::string first;
  std::string obstacle = "this build supports no plug-in device";
  for (const std::string& name : registry.Names())
  {
    std::vector<FoundDevice> found;
    if (!registry.CanBeFound(name))
    {
      continue;
    }
    const Status status = registry.FindDevices(name, clock, found);
    obstacle = status.IsOk() ? obstacle : status.Message();
    for (const FoundDevice& one : found)
    {
      std::string text = name + ":" + one.Argument;
      if (one.IsUsable)
      {
        return text;
      }
      first = first.empty() ? text : first;
    }
  }
  if (first.empty())
  {
    throw InputError(obstacle);
  }
  return first;
}

bool IsPluggedIn(const std::string& device)
{
  return Registry().CanBeFound(device.substr(0, device.find(':')));
}
} // namespace palpate
