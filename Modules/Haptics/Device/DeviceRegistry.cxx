#include "DeviceRegistry.h"

#include <algorithm>
#include <utility>

namespace palpate
{
const DeviceRegistry::Kind* DeviceRegistry::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Known.begin(), this->Known.end(),
                                  [&](const Kind& kind) { return kind.Name == name; });
  return found != this->Known.end() ? &*found : nullptr;
}

Status DeviceRegistry::Add(const std::string& name, const std::string& description, Factory factory,
                           Search search, Proof proof)
{
  if (name.empty() || name.find(':') != std::string::npos || factory == nullptr)
  {
    return Status::Failure("A kind of device needs a name without colon and a factory.");
  }
  if (this->Find(name) != nullptr)
  {
    return Status::Failure("There is already a kind of device named " + name + ".");
  }
  this->Known.push_back({name, description, std::move(factory), std::move(search), proof});
  return Status::Success();
}

Status DeviceRegistry::Make(const std::string& text, Clock& clock,
                            std::unique_ptr<HapticDevice>& device) const
{
  const std::size_t colon = text.find(':');
  const Kind* const kind = this->Find(text.substr(0, colon));
  if (kind == nullptr)
  {
    std::string known;
    for (const Kind& other : this->Known)
    {
      known += (known.empty() ? "" : ", ") + other.Name;
    }
    return Status::Failure("There is no kind of device named " + text.substr(0, colon) +
                           "; known are: " + (known.empty() ? "none" : known) + ".");
  }
  return kind->MakeDevice(clock, colon == std::string::npos ? "" : text.substr(colon + 1), device);
}
} // namespace palpate
