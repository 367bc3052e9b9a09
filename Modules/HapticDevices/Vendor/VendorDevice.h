#pragma once

#include "Clock.h"
#include "DeviceRegistry.h"
#include "HapticDevice.h"
#include "LatestValue.h"
#include "VendorArm.h"

#include <atomic>
#include <cstdint>
#include <memory>

namespace palpate
{
/// A device by its maker's library, whose thread takes the newest force and torque in each of its
/// steps: so those that the servo does not renew for 20 ms are followed by 0 N and 0 N mm however
/// the servo hangs, and none is displayed in the step of a failure. Proved with stand-ins for the
/// libraries only, never on hardware: what the library and the box do with a force is not known
/// here.
class VendorDevice final : public HapticDevice
{
public:
  /// Keeps the address of the clock, which must outlive it.
  VendorDevice(Clock& clock, std::unique_ptr<VendorArm> arm);
  ~VendorDevice() override { this->VendorDevice::Close(); }

  const DeviceCapabilities& Capabilities() const noexcept override
  {
    return this->Arm->Abilities();
  }
  DeviceState State() const noexcept override { return this->Life.load(); }
  std::string Problem() const override;
  Status Open() override;
  void Close() noexcept override;
  bool Read(DeviceSample& sample) noexcept override;
  bool Apply(const Vector3& force) noexcept override
  {
    return this->ApplyWrench(force, Vector3::Zero());
  }
  bool ApplyWrench(const Vector3& force, const Vector3& torque) noexcept override;

private:
  struct Command
  {
    PlainVector3 Force;    ///< N
    PlainVector3 Torque;   ///< N mm
    std::int64_t Time = 0; ///< ns
  };

  bool Step() noexcept;

  Clock& Time;
  std::unique_ptr<VendorArm> Arm;
  std::atomic<DeviceState> Life{DeviceState::Closed};
  std::atomic<bool> MustEnd{false};
  LatestValue<DeviceSample> Newest; // to the servo
  LatestValue<Command> Wanted;      // from the servo
  double MostForce = 0.0;           // N
  double MostTorque = 0.0;          // N mm
  DeviceSample Last;                // the arm's thread
};

/// Adds "openhaptics", "openhaptics:NAME" and "forcedimension".
Status RegisterVendorDevices(DeviceRegistry& registry);
} // namespace palpate
