#include "SimulatedRegistration.h"

#include "SimulatedDevice.h"

namespace palpate
{
Status RegisterSimulatedDevices(DeviceRegistry& registry)
{
  return registry.Add("simulated", "a computed device with a hand on it, to be moved by a program",
                      [](Clock& clock, const std::string&, std::unique_ptr<HapticDevice>& device)
                      {
                        device = std::make_unique<SimulatedDevice>(clock, SimulatedSettings());
                        return Status::Success();
                      });
}
} // namespace palpate
