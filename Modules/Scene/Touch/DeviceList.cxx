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
    report.Name += one.Argument.empty() ? "" : ":" + one.Argument;
    report.Details = one.Details;
    std::unique_ptr<HapticDevice> device;
    report.IsThere = one.IsUsable && registry.Make(report.Name, clock, device).IsOk();
    if (report.IsThere)
    {
      report.Capabilities = one.Capabilities.value_or(device->Capabilities());
    }
    reports.push_back(std::move(report));
  }
}

DeviceReport Untold(const DeviceRegistry::Kind& kind)
{
  DeviceReport report;
  report.Name = kind.Name;
  report.Description = kind.Description;
  report.IsUntried = kind.ProvedBy == DeviceRegistry::Proof::UntriedOnHardware;
  return report;
}

void List(const DeviceRegistry& registry, Clock& clock, const DeviceRegistry::Kind& kind,
          std::vector<DeviceReport>& reports)
{
  DeviceReport report = Untold(kind);
  if (kind.FindDevices)
  {
    Find(registry, clock, kind, report, reports);
    return;
  }
  Ask(registry, clock, report);
  reports.push_back(std::move(report));
}

std::string KindOf(const std::string& device)
{
  return device.substr(0, device.find(':'));
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

std::vector<DeviceReport> ListDevices(const std::string& inUse)
{
  const DeviceRegistry registry = Registry();
  SteadyClock clock;
  std::vector<DeviceReport> reports;
  for (const DeviceRegistry::Kind& kind : registry.Kinds())
  {
    if (kind.Name != KindOf(inUse))
    {
      List(registry, clock, kind, reports);
      continue;
    }
    DeviceReport report = Untold(kind);
    report.IsThere = true;
    report.Capabilities = UsualCapabilities(inUse);
    report.Details = "in use";
    reports.push_back(std::move(report));
  }
  return reports;
}

std::vector<DeviceReport> ListDevicesOf(const std::string& kind)
{
  const DeviceRegistry registry = Registry();
  SteadyClock clock;
  std::vector<DeviceReport> reports;
  if (const DeviceRegistry::Kind* const known = registry.Find(kind))
  {
    List(registry, clock, *known, reports);
  }
  return reports;
}

std::string StateLine(const DeviceReport& report)
{
  std::string line = report.Details;
  if (report.IsThere)
  {
    line = report.Capabilities.Name + ", " + line;
    line += report.IsUntried ? "; untried on hardware: test its safety stop first" : "";
  }
  else if (report.IsUntried)
  {
    line += " (Untried on hardware.)";
  }
  return line;
}

DeviceCapabilities UsualCapabilities(const std::string& device)
{
  SteadyClock clock;
  std::unique_ptr<HapticDevice> made;
  const bool isKnown = IsPluggedIn(device) && Registry().Make(device, clock, made).IsOk();
  return isKnown ? made->Capabilities() : DeviceCapabilities();
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
  const DeviceRegistry::Kind* const kind = registry.Find(KindOf(device));
  return kind != nullptr && kind->FindDevices;
}
} // namespace palpate
