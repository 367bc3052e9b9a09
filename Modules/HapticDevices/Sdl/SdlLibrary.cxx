#include "SdlLibrary.h"

#include <algorithm>
#include <dlfcn.h>

namespace palpate
{
namespace
{
constexpr std::uint32_t ControllersOnly = 0x2000; // SDL_INIT_GAMECONTROLLER
constexpr std::uint32_t AudioOnly = 0x10;         // SDL_INIT_AUDIO
constexpr std::uint16_t Floats = 0x8120;          // AUDIO_F32LSB, which both of our processors have
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
  this->Find(library, "SDL_OpenAudioDevice", this->OpenAudio);
  this->Find(library, "SDL_PauseAudioDevice", this->PauseAudio);
  this->Find(library, "SDL_CloseAudioDevice", this->CloseAudio);
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

Status SdlLibrary::Play(int rate, Renderer renderer, void* owner, std::uint32_t& player) const
{
  this->SetHint("SDL_NO_SIGNAL_HANDLERS", "1");
  if (this->InitSubSystem(AudioOnly) != 0)
  {
    return Status::Failure(std::string("There is no sound output: ") + this->GetError());
  }
  AudioSpec wanted;
  wanted.Rate = rate;
  wanted.Format = Floats;
  wanted.Channels = 1;
  wanted.Samples = 256;
  wanted.Callback = renderer;
  wanted.UserData = owner;
  // SDL converts to what the output takes.
  player = this->OpenAudio(nullptr, 0, &wanted, nullptr, 0);
  if (player == 0)
  {
    const std::string reason = this->GetError();
    this->QuitSubSystem(AudioOnly);
    return Status::Failure("There is no sound output: " + reason);
  }
  this->PauseAudio(player, 0);
  return Status::Success();
}

void SdlLibrary::Silence(std::uint32_t player) const noexcept
{
  this->CloseAudio(player);
  this->QuitSubSystem(AudioOnly);
}
} // namespace palpate
