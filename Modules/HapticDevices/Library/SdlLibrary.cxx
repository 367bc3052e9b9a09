#include "SdlLibrary.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr std::uint32_t ControllersOnly = 0x2000; // SDL_INIT_GAMECONTROLLER
constexpr std::uint32_t AudioOnly = 0x10;         // SDL_INIT_AUDIO
constexpr std::uint16_t Floats = 0x8120;          // AUDIO_F32LSB, which both of our processors have
} // namespace

void SdlLibrary::FindAll(DynamicLibrary& library)
{
  library.Find("SDL_InitSubSystem", this->InitSubSystem);
  library.Find("SDL_QuitSubSystem", this->QuitSubSystem);
  library.Find("SDL_SetHint", this->SetHint);
  library.Find("SDL_GetError", this->GetError);
  library.Find("SDL_NumJoysticks", this->NumJoysticks);
  library.Find("SDL_IsGameController", this->IsController);
  library.Find("SDL_GameControllerNameForIndex", this->NameOfIndex);
  library.Find("SDL_GameControllerOpen", this->OpenController);
  library.Find("SDL_GameControllerClose", this->CloseController);
  library.Find("SDL_GameControllerGetAttached", this->GetAttached);
  library.Find("SDL_GameControllerGetAxis", this->GetAxis);
  library.Find("SDL_GameControllerGetButton", this->GetButton);
  library.Find("SDL_GameControllerUpdate", this->UpdateControllers);
  library.Find("SDL_GameControllerRumble", this->RumbleController);
  library.Find("SDL_OpenAudioDevice", this->OpenAudio);
  library.Find("SDL_PauseAudioDevice", this->PauseAudio);
  library.Find("SDL_CloseAudioDevice", this->CloseAudio);
  library.Find("SDL_TLSCleanup", this->CleanThread);
}

Status SdlLibrary::Load(std::shared_ptr<const SdlLibrary>& made)
{
  DynamicLibrary library("PALPATE_LIBSDL2", {"libSDL2-2.0.so.0"});
  std::shared_ptr<SdlLibrary> loaded(new SdlLibrary);
  loaded->FindAll(library);
  if (!library.IsWhole())
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
