#pragma once

#include "Clock.h"
#include "DeviceRegistry.h"
#include "HapticDevice.h"
#include "TouchRecording.h"

#include <atomic>
#include <memory>

namespace palpate
{
/// A device that plays a recorded session: at each time since Open it returns the sample of the
/// tick at that time, and accepts forces where they were accepted. At the end it enters Error, "has
/// ended". Forces have no effect on it; its capabilities, also HasMotors, are the recorded ones, so
/// that the same faults end by themselves.
class ReplayDevice final : public HapticDevice
{
public:
  /// Keeps the address of the clock, which must outlive it.
  ReplayDevice(Clock& clock, std::shared_ptr<const TouchRecording> recording);

  const DeviceCapabilities& Capabilities() const noexcept override { return this->Abilities; }
  DeviceState State() const noexcept override { return this->Life; }
  std::string Problem() const override;
  /// The first tick starts now.
  Status Open() override;
  void Close() noexcept override { this->Life = DeviceState::Closed; }
  bool Read(DeviceSample& sample) noexcept override;
  bool Apply(const Vector3& force) noexcept override;

private:
  Clock& Time;
  std::shared_ptr<const TouchRecording> Recording;
  DeviceCapabilities Abilities;
  std::atomic<DeviceState> Life{DeviceState::Closed};
  std::int64_t Shift = 0;  // ns, from recorded time to the clock's
  std::size_t Current = 0; // tick
};

/// Adds "replay:<file>": a ReplayDevice of a recorded session.
Status RegisterReplayDevices(DeviceRegistry& registry);
} // namespace palpate
