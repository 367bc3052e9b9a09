#include "DeviceHoming.h"

#include "FixedRateLoop.h"
#include "LatestValue.h"
#include "OpenBuiltInDevice.h"
#include "RealtimeThread.h"
#include "Refusal.h"
#include "SteadyClock.h"
#include "Units.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

namespace palpate
{
namespace
{
// Published by the loop's thread.
struct LoopView
{
  DeviceSample Sample;
  std::uint64_t Samples = 0;
};

// Reads samples at the device's rate and applies no force.
class ForcelessLoop
{
public:
  ForcelessLoop(HapticDevice& device, Clock& clock)
      : Device(device), Loop(clock, PeriodOf(device.Capabilities()))
  {
  }
  ~ForcelessLoop() { this->Stop(); }
  ForcelessLoop(const ForcelessLoop&) = delete;
  ForcelessLoop& operator=(const ForcelessLoop&) = delete;

  Status Start()
  {
    return this->Thread.Start(
        {}, [this] { this->Loop.Run([this](const TickInfo& tick) { return this->Tick(tick); }); });
  }
  void Stop()
  {
    this->Loop.Stop();
    this->Thread.Join();
  }

  const LoopView& Latest() noexcept { return this->Published.Latest(); }
  const RealtimeGrant& Grant() const noexcept { return this->Thread.Grant(); }
  // Valid after Stop.
  const PeriodStatistics& Periods() const noexcept { return this->Counted; }
  std::uint64_t Ticks() const noexcept { return this->TickCount; }

private:
  static std::int64_t PeriodOf(const DeviceCapabilities& device)
  {
    constexpr double DefaultRate = 1000.0; // Hz
    return std::llround(1.0 /
                        (SecondsPerNanosecond * (device.Rate > 0.0 ? device.Rate : DefaultRate)));
  }

  bool Tick(const TickInfo& tick) noexcept
  {
    ++this->TickCount;
    DeviceSample sample;
    const bool goesOn = this->Device.Read(sample);
    // Zero force need not be accepted in this very tick.
    static_cast<void>(this->Device.Apply(Vector3::Zero()));
    if (goesOn && sample.Sequence != this->View.Sample.Sequence)
    {
      if (this->View.Samples > 0)
      {
        this->Counted.Add(tick.Started - this->LastSample);
      }
      this->LastSample = tick.Started;
      this->View.Sample = sample;
      ++this->View.Samples;
      this->Published.Publish(this->View);
    }
    return goesOn;
  }

  HapticDevice& Device;
  FixedRateLoop Loop;
  LatestValue<LoopView> Published;
  // Used by the loop's thread only.
  LoopView View;
  std::int64_t LastSample = 0; // ns
  std::uint64_t TickCount = 0;
  PeriodStatistics Counted;
  RealtimeThread Thread;
};
} // namespace

HomingReport HomeDevice(HapticDevice& device, double leastSeconds,
                        const std::function<bool(const HomingView&)>& show)
{
  constexpr auto Nap = std::chrono::milliseconds(50);
  SteadyClock clock;
  ForcelessLoop loop(device, clock);
  const std::int64_t start = clock.Now();
  HomingReport report;
  HomingView view;
  const auto look = [&]
  {
    view.Seconds = SecondsPerNanosecond * static_cast<double>(clock.Now() - start);
    view.State = device.State();
    view.Guidance = device.Guidance();
    view.Sample = loop.Latest().Sample;
    view.Rate =
        static_cast<double>(loop.Latest().Samples) / std::max(view.Seconds, SecondsPerNanosecond);
    if (view.State == DeviceState::Ready && report.HomedAfter == 0.0)
    {
      report.HomedAfter = view.Seconds;
    }
    return show(view) && (view.State == DeviceState::Homing ||
                          (view.State == DeviceState::Ready && view.Seconds < leastSeconds));
  };
  // Guidance is shown before the first sample may end the homing.
  bool goesOn = look();
  RequireInput(loop.Start());
  while (goesOn)
  {
    std::this_thread::sleep_for(Nap);
    goesOn = look();
  }
  loop.Stop();
  report.State = device.State();
  report.Problem = device.Problem();
  report.Seconds = view.Seconds;
  report.Ticks = loop.Ticks();
  report.Periods = loop.Periods();
  report.ConnectionReport = device.ConnectionReport();
  report.ThreadAdvice = loop.Grant().Advice;
  return report;
}

HomingReport HomeDevice(const std::string& name, double leastSeconds,
                        const std::function<bool(const HomingView&)>& show)
{
  SteadyClock clock;
  std::unique_ptr<HapticDevice> device;
  RequireInput(MakeBuiltInDevice(name, clock, device));
  const Status status = device->Open();
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  HomingReport report = HomeDevice(*device, leastSeconds, show);
  device->Close();
  return report;
}
} // namespace palpate
