#include "DeviceRegistry.h"

#include <algorithm>
#include <utility>

namespace palpate
{
const DeviceRegistry::Kind* DeviceRegistry::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Kinds.begin(), this->Kinds.end(),
                                  [&](const Kind& kind) { return kind.Name == name; });
  return found != this->Kinds.end() ? &*found : nullptr;
}

Status DeviceRegistry::Add(const std::string& name, const std::string& description, Factory factory,
                           Search search)
{
  if (name.empty() || name.find(':') != std::string::npos || factory == nullptr)
  {
    return Status::Failure("A kind of device needs a name without colon and a factory.");
  }
  if (this->Find(name) != nullptr)
  {
    return Status::Failure("There is already a kind of device named " + name + ".");
  }
  this->Kinds.push_back({name, description, std::move(factory), std::move(search)});
  return Status::Success();
}

std::vector<std::string> DeviceRegistry::Names() const
{
  std::vector<std::string> names;
  for (const Kind& kind : this->Kinds)
  {
    names.push_back(kind.Name);
  }
  return names;
}

std::string DeviceRegistry::Description(const std::string& name) const
{
  const Kind* const kind = this->Find(name);
  return kind != nullptr ? kind->Description : "";
}

bool DeviceRegistry::CanBeFound(const std::string& name) const
{
  const Kind* const kind = this->Find(name);
  return kind != nullptr && kind->FindDevices != nullptr;
}

Status DeviceRegistry::FindDevices(const std::string& name, Clock& clock,
                                   std::vector<FoundDevice>& found) const
{
  found.clear();
  return this->CanBeFound(name)
             ? this->Find(name)->FindDevices(clock, found)
             : Status::Failure("Devices of the kind " + name + " cannot be searched for.");
}

Status DeviceRegistry::Make(const std::string& text, Clock& clock,
                            std::unique_ptr<HapticDevice>& device) const
{
  const std::size_t colon = text.find(':');
  const Kind* const kind = this->Find(text.substr(0, colon));
  if (kind == nullptr)
  {
    std::string known;
    for (const std::string& name : this->Names())
    {
      known += (known.empty() ? "" : ", ") + name;
    }
    return Status::Failure("There is no kind of device named " + text.substr(0, colon) +
                           "; known are: " + (known.empty() ? "none" : known) + ".");
  }
  return kind->MakeDevice(clock, colon == std::string::npos ? "" : text.substr(colon + 1), device);
}
} // namespace palpate
