#include "SpaceMouseDevice.h"

#include "SpaceMouseSource.h"
#include "SteeredDevice.h"

#include <memory>

namespace palpate
{
Status RegisterSpaceMouseDevices(DeviceRegistry& registry)
{
  return registry.Add(
      "spacemouse",
      "a computed hand that a SpaceMouse steers, by spacenavd; spacemouse[:SOCKET]; no force is "
      "felt",
      [](Clock& clock, const std::string& argument, std::unique_ptr<HapticDevice>& device)
      {
        device = std::make_unique<SteeredDevice>(
            clock, std::make_unique<SpaceMouseSource>(
                       argument.empty() ? SpaceMouseSource::DefaultSocket() : argument));
        return Status::Success();
      },
      [](Clock&, std::vector<FoundDevice>& found)
      {
        SpaceMouseSource source(SpaceMouseSource::DefaultSocket());
        const Status status = source.Open();
        if (status.IsOk())
        {
          found.push_back(
              {"", true, "spacenavd answers; move the cap to see that it is plugged in"});
        }
        return status;
      },
      DeviceRegistry::Proof::UntriedOnHardware);
}
} // namespace palpate
