#include "ReplayRegistration.h"

#include "ReplayDevice.h"

namespace palpate
{
Status RegisterReplayDevices(DeviceRegistry& registry)
{
  return registry.Add(
      "replay", "what a device did in a recorded session; replay:<file>",
      [](Clock& clock, const std::string& path, std::unique_ptr<HapticDevice>& device)
      {
        if (path.empty())
        {
          return Status::Failure("A replay needs a session's file, replay:<file>.");
        }
        auto recording = std::make_shared<TouchRecording>();
        Status status = ReadTouchRecording(path, *recording);
        if (status.IsOk())
        {
          device = std::make_unique<ReplayDevice>(clock, std::move(recording));
        }
        return status;
      });
}
} // namespace palpate
