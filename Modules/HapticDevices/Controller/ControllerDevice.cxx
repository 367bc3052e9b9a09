#include "ControllerDevice.h"

#include "ControllerSource.h"
#include "DecimalText.h"
#include "SteeredDevice.h"

#include <filesystem>
#include <unistd.h>

namespace palpate
{
namespace
{
// SDL leaves out what this user may not read.
std::string Forbidden()
{
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/input", failure))
  {
    const std::string path = entry.path().string();
    if (entry.path().filename().string().rfind("js", 0) == 0 && access(path.c_str(), R_OK) != 0)
    {
      return path;
    }
  }
  return {};
}

Status NoController()
{
  const std::string forbidden = Forbidden();
  return Status::Failure(
      forbidden.empty() ? "No game controller is plugged in: plug one in, or pair it."
                        : "The game controller at " + forbidden +
                              " may not be read by this user: add the user to the group input.");
}

Status FindControllers(std::vector<FoundDevice>& found)
{
  std::shared_ptr<const SdlLibrary> sdl;
  Status status = SdlLibrary::Load(sdl);
  if (status.IsOk())
  {
    status = sdl->Begin();
  }
  if (!status.IsOk())
  {
    return status;
  }
  for (const std::string& name : sdl->Names())
  {
    found.push_back({std::to_string(found.size() + 1), true, name});
  }
  sdl->End();
  return found.empty() ? NoController() : Status::Success();
}
} // namespace

Status RegisterControllerDevices(DeviceRegistry& registry)
{
  return registry.Add(
      "controller",
      "a computed hand that a game controller steers, by SDL 2; controller[:NUMBER]; its motors "
      "tell what is touched",
      [](Clock& clock, const std::string& argument, std::unique_ptr<HapticDevice>& device)
      {
        const int number = argument.empty() ? 1 : ParseInteger(argument).value_or(0);
        if (number < 1)
        {
          return Status::Failure("The number of a game controller is 1 or more, not " + argument +
                                 ".");
        }
        device = std::make_unique<SteeredDevice>(clock, std::make_unique<ControllerSource>(number));
        return Status::Success();
      },
      [](Clock&, std::vector<FoundDevice>& found) { return FindControllers(found); },
      DeviceRegistry::Proof::UntriedOnHardware);
}
} // namespace palpate
