#include "ServoThread.h"

#include "EmergencyStop.h"

#include <cmath>

namespace palpate
{
namespace
{
// Copying the statistics takes about a microsecond.
constexpr std::uint64_t TicksBetweenStatistics = 50;
} // namespace

ServoThread::ServoThread(HapticDevice& device, Clock& clock, const ServoSettings& settings)
    : Touch(device, settings), Device(device), Time(clock), Settings(settings)
{
}

Status ServoThread::Start(const RealtimeRequest& request)
{
  if (this->IsRunning())
  {
    return Status::Failure("The servo is already running.");
  }
  if (!(this->Settings.Rate > 0.0 && this->Settings.Rate <= 1e5))
  {
    return Status::Failure("The servo's rate must be above 0 and at most 100000 Hz.");
  }
  const auto period = static_cast<std::int64_t>(std::llround(1e9 / this->Settings.Rate));
  this->Rate = std::make_unique<FixedRateLoop>(this->Time, period);
  this->Counted = {};
  this->Published.Publish(this->Counted);
  this->Touch.Resume();
  return this->Thread.Start(
      request,
      [this] { this->Rate->Run([this](const TickInfo& tick) { return this->Tick(tick); }); });
}

void ServoThread::Stop()
{
  if (this->IsRunning())
  {
    this->Rate->Stop();
    this->Thread.Join();
    // A device that does not accept it has stopped by itself.
    static_cast<void>(this->Device.Apply(Vector3::Zero()));
  }
}

bool ServoThread::Tick(const TickInfo& tick) noexcept
{
  if (EmergencyStop::IsOrdered())
  {
    this->Touch.SwitchOff();
  }
  this->Touch.Tick(tick);
  if (tick.Number > 0)
  {
    this->Counted.Periods.Add(tick.Started - this->LastStarted);
  }
  this->LastStarted = tick.Started;
  this->Counted.Periods.AddMisses(tick.SkippedPeriods);
  this->Counted.Durations.Add(this->Time.Now() - tick.Started);
  this->Counted.Durations.AddMisses(tick.IsLate ? 1 : 0);
  if (tick.Number % TicksBetweenStatistics == 0)
  {
    this->Published.Publish(this->Counted);
  }
  return true;
}
} // namespace palpate
