#pragma once

#include "Clock.h"
#include "HapticDevice.h"

#include <cstdint>

namespace palpate::test
{
/// A device that rests 1 mm below the origin; its samples have the clock's current time.
class TimedDevice final : public HapticDevice
{
public:
  explicit TimedDevice(const Clock& clock) : Time(clock)
  {
    this->Abilities.MaximumForce = 8.0;
    this->Abilities.Rate = 1000.0;
  }
  const DeviceCapabilities& Capabilities() const noexcept override { return this->Abilities; }
  DeviceState State() const noexcept override { return DeviceState::Ready; }
  std::string Problem() const override { return ""; }
  Status Open() override { return Status::Success(); }
  void Close() noexcept override {}
  bool Read(DeviceSample& sample) noexcept override
  {
    sample.Position.Z = -1.0;
    sample.Sequence = ++this->Reads;
    sample.Time = this->Time.Now();
    return true;
  }
  bool Apply(const Vector3& force) noexcept override
  {
    this->Applied = force;
    return true;
  }

  Vector3 Applied = Vector3::Zero();

private:
  const Clock& Time;
  DeviceCapabilities Abilities;
  std::uint64_t Reads = 0;
};
} // namespace palpate::test
