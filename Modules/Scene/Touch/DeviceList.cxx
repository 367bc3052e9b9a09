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
void Find(const DeviceRegistry& registry, Clock& clock, const DeviceRegistry::Kind& kind,
          const DeviceReport& empty, std::vector<DeviceReport>& reports)
{
  std::vector<FoundDevice> found;
  const Status status = kind.FindDevices(clock, found);
  if (!status.IsOk())
  {
    reports.push_back(empty);
    reports.back().Details = status.Message();
  }
  for (const FoundDevice& one : found)
  {
    DeviceReport report = empty;
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
  for (const DeviceRegistry::Kind& kind : registry.Kinds())
  {
    DeviceReport report;
    report.Name = kind.Name;
    report.Description = kind.Description;
    if (kind.FindDevices)
    {
      Find(registry, clock, kind, report, reports);
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
  std::string obstacle;
  for (const DeviceRegistry::Kind& kind : registry.Kinds())
  {
    std::vector<FoundDevice> found;
    if (!kind.FindDevices)
    {
      continue;
    }
    const Status status = kind.FindDevices(clock, found);
    obstacle = obstacle.empty() ? status.Message() : obstacle;
    for (const FoundDevice& one : found)
    {
      std::string text = kind.Name + ":" + one.Argument;
      if (one.IsUsable)
      {
        return text;
      }
      first = first.empty() ? text : first;
    }
  }
  if (first.empty())
  {
    throw InputError(obstacle.empty() ? "this build supports no plug-in device" : obstacle);
  }
  return first;
}

bool IsPluggedIn(const std::string& device)
{
  const DeviceRegistry registry = Registry();
  const DeviceRegistry::Kind* const kind = registry.Find(device.substr(0, device.find(':')));
  return kind != nullptr && kind->FindDevices;
}
} // namespace palpate
