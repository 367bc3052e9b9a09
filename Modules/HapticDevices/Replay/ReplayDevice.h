#pragma once

#include "Clock.h"
#include "HapticDevice.h"
#include "TouchRecording.h"

#include <atomic>
#include <memory>

namespace palpate
{
/// A device that does what one did in a recorded session: at each time since Open it gives the
/// sample of the tick that was then, and takes forces where they were taken. At the end it is an
/// Error, "has ended". The forces it is given move nothing.
class ReplayDevice final : public HapticDevice
{
public:
  /// Keeps the address of the clock, which must outlive it.
  ReplayDevice(Clock& clock, std::shared_ptr<const TouchRecording> recording);

  const DeviceCapabilities& Capabilities() const noexcept override { return this->Abilities; }
  DeviceState State() const noexcept override { return this->Life; }
  std::string Problem() const override;
  /// The first tick is now.
  Status Open() override;
  void Close() noexcept override { this->Life = DeviceState::Closed; }
  bool Read(DeviceSample& sample) noexcept override;
  bool Apply(const Vector3& force) noexcept override;

private:
  Clock& Time;
  std::shared_ptr<const TouchRecording> Recording;
  DeviceCapabilities Abilities;
  std::atomic<DeviceState> Life{DeviceState::Closed};
  std::int64_t Shift = 0;  // ns, from the recorded time to the clock's
  std::size_t Current = 0; // tick
};
} // namespace palpate
