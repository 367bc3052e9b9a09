#include "ReplayDevice.h"

#include <utility>

namespace palpate
{
ReplayDevice::ReplayDevice(Clock& clock, std::shared_ptr<const TouchRecording> recording)
    : Time(clock), Recording(std::move(recording)), Abilities(this->Recording->Session.Device)
{
  this->Abilities.Name = "Recorded device";
}

std::string ReplayDevice::Problem() const
{
  return this->State() == DeviceState::Error ? "The recording has ended, or shows a device that "
                                               "failed here."
                                             : "";
}

Status ReplayDevice::Open()
{
  if (this->Recording->Ticks.empty())
  {
    return Status::Failure("The recording has no ticks.");
  }
  if (this->State() != DeviceState::Closed)
  {
    return Status::Failure("The recorded device is open already.");
  }
  this->Current = 0;
  this->Shift = this->Time.Now() - this->Recording->Ticks.front().Tick.Started;
  this->Life = this->Recording->Ticks.front().State;
  return Status::Success();
}

bool ReplayDevice::Read(DeviceSample& sample) noexcept
{
  if (this->State() == DeviceState::Closed)
  {
    return false;
  }
  const std::vector<TouchState>& ticks = this->Recording->Ticks;
  const std::int64_t recordedTime = this->Time.Now() - this->Shift;
  while (this->Current + 1 < ticks.size() && ticks[this->Current + 1].Tick.Started <= recordedTime)
  {
    ++this->Current;
  }
  // The last tick lasts for the maximum age of a sample.
  constexpr std::int64_t lastTick = 10'000'000;
  const TouchState& now = ticks[this->Current];
  const bool hasEnded =
      this->Current + 1 == ticks.size() && recordedTime - now.Tick.Started > lastTick;
  this->Life = hasEnded ? DeviceState::Error : now.State;
  sample = now.Sample;
  sample.Time += this->Shift;
  return now.HasSample && !hasEnded;
}

bool ReplayDevice::Apply(const Vector3&) noexcept
{
  return this->State() != DeviceState::Closed && this->Recording->Ticks[this->Current].WasTaken;
}

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
