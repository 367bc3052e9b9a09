#include "SdlLibrary.h"

#include <algorithm>
#include <dlfcn.h>

namespace palpate
{
namespace
{
constexpr std::uint32_t ControllersOnly = 0x2000; // SDL_INIT_GAMECONTROLLER
} // namespace

template <typename Function>
void SdlLibrary::Find(void* library, const char* name, Function& function)
{
  function = reinterpret_cast<Function>(dlsym(library, name));
  this->IsWhole = this->IsWhole && function != nullptr;
}

void SdlLibrary::FindAll(void* library)
{
  this->Find(library, "SDL_InitSubSystem", this->InitSubSystem);
  this->Find(library, "SDL_QuitSubSystem", this->QuitSubSystem);
  this->Find(library, "SDL_SetHint", this->SetHint);
  this->Find(library, "SDL_GetError", this->GetError);
  this->Find(library, "SDL_NumJoysticks", this->NumJoysticks);
  this->Find(library, "SDL_IsGameController", this->IsController);
  this->Find(library, "SDL_GameControllerNameForIndex", this->NameOfIndex);
  this->Find(library, "SDL_GameControllerOpen", this->OpenController);
  this->Find(library, "SDL_GameControllerClose", this->CloseController);
  this->Find(library, "SDL_GameControllerGetAttached", this->GetAttached);
  this->Find(library, "SDL_GameControllerGetAxis", this->GetAxis);
  this->Find(library, "SDL_GameControllerGetButton", this->GetButton);
  this->Find(library, "SDL_GameControllerUpdate", this->UpdateControllers);
  this->Find(library, "SDL_GameControllerRumble", this->RumbleController);
}

// It is never closed: SDL has threads of its own.
Status SdlLibrary::Load(std::shared_ptr<const SdlLibrary>& made)
{
  void* const library = dlopen("libSDL2-2.0.so.0", RTLD_NOW | RTLD_LOCAL);
  std::shared_ptr<SdlLibrary> loaded(new SdlLibrary);
  if (library != nullptr)
  {
    loaded->FindAll(library);
  }
  if (library == nullptr || !loaded->IsWhole)
  {
    return Status::Failure("SDL 2 is not installed, or too old: install libsdl2-2.0-0.");
  }
  made = std::move(loaded);
  return Status::Success();
}

Status SdlLibrary::Begin() const
{
  // Its own answer to Ctrl-C would be in the way of ours; and other windows may be in front.
  this->SetHint("SDL_NO_SIGNAL_HANDLERS", "1");
  this->SetHint("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1");
  return this->InitSubSystem(ControllersOnly) == 0
             ? Status::Success()
             : Status::Failure(std::string("SDL 2 does not start: ") + this->GetError());
}

void SdlLibrary::End() const noexcept
{
  this->QuitSubSystem(ControllersOnly);
}

// Their indices among the joysticks.
std::vector<int> SdlLibrary::Controllers() const
{
  std::vector<int> controllers;
  for (int index = 0; index < this->NumJoysticks(); ++index)
  {
    if (this->IsController(index) != 0)
    {
      controllers.push_back(index);
    }
  }
  return controllers;
}

std::vector<std::string> SdlLibrary::Names() const
{
  std::vector<std::string> names;
  for (const int index : this->Controllers())
  {
    const char* name = this->NameOfIndex(index);
    names.emplace_back(name != nullptr ? name : "game controller");
  }
  return names;
}

void* SdlLibrary::Open(int number) const
{
  const std::vector<int> controllers = this->Controllers();
  const bool isThere = number >= 1 && number <= static_cast<int>(controllers.size());
  return isThere ? this->OpenController(controllers[static_cast<std::size_t>(number) - 1])
                 : nullptr;
}

double SdlLibrary::Axis(void* controller, int axis) const noexcept
{
  return std::max(-1.0, this->GetAxis(controller, axis) / 32767.0);
}
} // namespace palpate
