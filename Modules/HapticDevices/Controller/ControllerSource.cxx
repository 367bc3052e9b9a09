#include "ControllerSource.h"

#include <chrono>

namespace palpate
{
namespace
{
constexpr std::chrono::milliseconds Period(4);
constexpr int PeriodsPerRumble = 4; // a controller takes some 60 a second
constexpr int RumbleLasts = 100;    // ms, if nothing renews it

enum Axis
{
  LeftX,
  LeftY,
  RightX,
  RightY,
  LeftTrigger,
  RightTrigger
};
constexpr int LeftShoulder = 9;
constexpr int RightShoulder = 10;
} // namespace

std::string ControllerSource::Problem() const
{
  return "The game controller was unplugged: plug it in, then open it again.";
}

Status ControllerSource::Open()
{
  this->Close();
  Status status = SdlLibrary::Load(this->Sdl);
  if (status.IsOk())
  {
    this->MustEnd = false;
    this->Cues = {};
    std::promise<Status> opened;
    std::future<Status> result = opened.get_future();
    this->Thread = std::thread([this, &opened] { this->Run(opened); });
    status = result.get();
  }
  return status;
}

void ControllerSource::Close() noexcept
{
  this->MustEnd = true;
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

void ControllerSource::Run(std::promise<Status>& opened)
{
  const Status begun = this->Sdl->Begin();
  if (!begun.IsOk())
  {
    opened.set_value(begun);
    return;
  }
  void* const controller = this->Sdl->Open(this->Number);
  this->IsThere = controller != nullptr;
  if (controller == nullptr)
  {
    opened.set_value(Status::Failure(
        this->Number == 1 ? "No game controller is plugged in: plug one in, or pair it."
                          : "There is no game controller " + std::to_string(this->Number) + "."));
  }
  else
  {
    this->Newest.Publish(this->Ask(controller));
    opened.set_value(Status::Success()); // which ends the promise's life
    this->Poll(controller);
    this->Sdl->Rumble(controller, 0, 0, 0);
    this->Sdl->Close(controller);
  }
  this->Sdl->End();
  this->Sdl->LeaveThread();
}

void ControllerSource::Poll(void* controller)
{
  bool isStill = true;
  for (int n = 1; !this->MustEnd; n = n % PeriodsPerRumble + 1)
  {
    this->Sdl->Update();
    this->IsThere = this->Sdl->IsAttached(controller);
    this->Newest.Publish(this->Ask(controller));
    if (n == PeriodsPerRumble)
    {
      const ControllerRumble& wanted = this->Wanted.Latest();
      if (!wanted.IsStill() || !isStill)
      {
        this->Sdl->Rumble(controller, wanted.Slow, wanted.Fast, RumbleLasts);
      }
      isStill = wanted.IsStill();
    }
    std::this_thread::sleep_for(Period);
  }
}

SteeringInput ControllerSource::Ask(void* controller) const noexcept
{
  const auto axis = [&](int number) { return this->Sdl->Axis(controller, number); };
  SteeringInput input;
  for (int button = 0; button < SdlLibrary::ButtonCount; ++button)
  {
    input.Buttons |= this->Sdl->IsPressed(controller, button) ? 1u << button : 0u;
  }
  const auto isPressed = [&](int button) { return static_cast<int>(input.Buttons >> button & 1u); };
  input.Push = Vector3(axis(LeftX), -axis(LeftY), axis(LeftTrigger) - axis(RightTrigger));
  input.Turn =
      Vector3(axis(RightY), axis(RightX), isPressed(LeftShoulder) - isPressed(RightShoulder));
  return input;
}

bool ControllerSource::Read(SteeringInput& input) noexcept
{
  input = this->Newest.Latest();
  return this->IsThere;
}

void ControllerSource::Show(const TouchState& state) noexcept
{
  this->Wanted.Publish(ControllerRumble::Of(this->Cues.Update(state)));
}
} // namespace palpate
