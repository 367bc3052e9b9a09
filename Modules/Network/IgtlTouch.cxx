#include "IgtlTouch.h"

#include "IgtlMessages.h"

#include <string>

namespace palpate
{
std::vector<std::uint8_t> IgtlTouchMessages(const IgtlTouch& before, const IgtlTouch& now)
{
  std::vector<std::uint8_t> all;
  const auto add = [&all](const std::vector<std::uint8_t>& message)
  { all.insert(all.end(), message.begin(), message.end()); };
  add(IgtlPlaceMessage("Probe", now.ProbeWorld));
  add(IgtlPlaceMessage("Proxy", now.ProxyWorld));
  // Not named Force, which moves a peer's motors.
  const PlainVector3& force = now.ForceWorld;
  add(IgtlForceMessage("ContactForce", Vector3(-force.X, -force.Y, force.Z)));
  if (now.Structure != before.Structure)
  {
    add(IgtlEventMessage(now.Structure < 0
                             ? "contact ends"
                             : "contact with structure " + std::to_string(now.Structure + 1)));
  }
  const std::string fault = now.Fault;
  if (fault != before.Fault)
  {
    add(IgtlEventMessage(fault.empty() ? "forces are on" : "forces are off: " + fault));
  }
  return all;
}
} // namespace palpate
