#pragma once

#include "Clock.h"
#include "HapticDevice.h"
#include "LatestValue.h"

#include <atomic>

namespace palpate::test
{
/// A device, open from the start, whose position another thread sets, and which reports the last
/// applied force.
class PlacedDevice : public HapticDevice
{
public:
  explicit PlacedDevice(Clock& clock) : Time(clock)
  {
    this->Abilities.Name = "placed device";
    this->Abilities.Workspace = {Vector3::Constant(-40.0), Vector3::Constant(40.0)};
    this->Abilities.MaximumForce = 8.0;
    this->Abilities.MaximumDamping = 0.02;
    this->Abilities.Rate = 1000.0;
    this->Abilities.HasMotors = false; // so that a busy machine's delays end by themselves
  }

  void Put(const Vector3& position, unsigned buttons)
  {
    DeviceSample next;
    next.Position = position;
    next.Buttons = buttons;
    this->Wanted.Publish(next);
  }
  double Force() const { return this->Applied.load(); } ///< N, its length

  const DeviceCapabilities& Capabilities() const noexcept override { return this->Abilities; }
  DeviceState State() const noexcept override { return DeviceState::Ready; }
  std::string Problem() const override { return ""; }
  Status Open() override { return Status::Success(); }
  void Close() noexcept override { this->Applied = 0.0; }
  bool Read(DeviceSample& sample) noexcept override
  {
    sample = this->Wanted.Latest();
    sample.Sequence = ++this->Count;
    sample.Time = this->Time.Now();
    return true;
  }
  bool Apply(const Vector3& force) noexcept override
  {
    this->Applied = force.norm();
    return true;
  }

private:
  Clock& Time;
  DeviceCapabilities Abilities;
  LatestValue<DeviceSample> Wanted;
  std::atomic<double> Applied{0.0};
  std::uint64_t Count = 0;
};
} // namespace palpate::test
