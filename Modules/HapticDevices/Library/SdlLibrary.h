#pragma once

#include "DynamicLibrary.h"
#include "Status.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// The few calls of SDL 2 (wiki.libsdl.org) for game controllers and sound, from the user's
/// library: it is opened when it is needed, so that nobody else has to have it. All calls of one
/// controller are of one thread.
class SdlLibrary
{
public:
  static constexpr int AxisCount =
      6; ///< left x, y, right x, y (right and down are positive), triggers
  static constexpr int ButtonCount = 15; ///< A, B, X, Y, back, guide, start, sticks, shoulders, pad

  /// Opens it. Fails with what to install.
  static Status Load(std::shared_ptr<const SdlLibrary>& made);

  /// Every successful Begin needs an End.
  Status Begin() const;
  void End() const noexcept;
  /// At the end of a thread that has called SDL: what it keeps for that thread.
  void LeaveThread() const noexcept { this->CleanThread(); }
  /// Of the controllers that are plugged in, in the order of their numbers.
  std::vector<std::string> Names() const;
  /// Null if there are not that many.
  void* Open(int number) const;
  void Close(void* controller) const noexcept { this->CloseController(controller); }
  /// Takes what changed.
  void Update() const noexcept { this->UpdateControllers(); }
  bool IsAttached(void* controller) const noexcept { return this->GetAttached(controller) != 0; }
  /// From -1 to 1.
  double Axis(void* controller, int axis) const noexcept;
  bool IsPressed(void* controller, int button) const noexcept
  {
    return this->GetButton(controller, button) != 0;
  }
  /// Turns the motors for so long (ms), or until the next call.
  void Rumble(void* controller, std::uint16_t slow, std::uint16_t fast, int duration) const noexcept
  {
    this->RumbleController(controller, slow, fast, static_cast<std::uint32_t>(duration));
  }

  /// Fills so many bytes with samples (float, one channel, from -1 to 1); SDL's own thread.
  using Renderer = void (*)(void* owner, std::uint8_t* samples, int bytes);
  /// Begins to play by the default output, `rate` samples a second, some 6 ms at a time. `player`
  /// is what Silence takes; `owner` must live until then.
  Status Play(int rate, Renderer renderer, void* owner, std::uint32_t& player) const;
  /// Ends it; the renderer is not called any more.
  void Silence(std::uint32_t player) const noexcept;

private:
  struct AudioSpec // of SDL
  {
    int Rate = 0;
    std::uint16_t Format = 0;
    std::uint8_t Channels = 0;
    std::uint8_t Zero = 0;
    std::uint16_t Samples = 0;
    std::uint16_t Padding = 0;
    std::uint32_t Size = 0;
    void (*Callback)(void*, std::uint8_t*, int) = nullptr;
    void* UserData = nullptr;
  };
  SdlLibrary() = default;
  void FindAll(DynamicLibrary& library);
  std::vector<int> Controllers() const;

  int (*InitSubSystem)(std::uint32_t) = nullptr;
  void (*QuitSubSystem)(std::uint32_t) = nullptr;
  int (*SetHint)(const char*, const char*) = nullptr;
  const char* (*GetError)() = nullptr;
  int (*NumJoysticks)() = nullptr;
  int (*IsController)(int) = nullptr;
  const char* (*NameOfIndex)(int) = nullptr;
  void* (*OpenController)(int) = nullptr;
  void (*CloseController)(void*) = nullptr;
  int (*GetAttached)(void*) = nullptr;
  std::int16_t (*GetAxis)(void*, int) = nullptr;
  std::uint8_t (*GetButton)(void*, int) = nullptr;
  void (*UpdateControllers)() = nullptr;
  std::uint32_t (*OpenAudio)(const char*, int, const AudioSpec*, AudioSpec*, int) = nullptr;
  void (*PauseAudio)(std::uint32_t, int) = nullptr;
  void (*CloseAudio)(std::uint32_t) = nullptr;
  void (*CleanThread)() = nullptr;
  int (*RumbleController)(void*, std::uint16_t, std::uint16_t, std::uint32_t) = nullptr;
};
} // namespace palpate
