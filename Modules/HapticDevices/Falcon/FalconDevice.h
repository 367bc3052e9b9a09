#pragma once

#include "Clock.h"
#include "DeviceRegistry.h"
#include "FalconBoot.h"
#include "FalconCalibration.h"
#include "FalconExchange.h"
#include "FalconKinematics.h"
#include "FalconLink.h"
#include "HapticDevice.h"
#include "HomingWatch.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

namespace palpate
{
struct FalconSettings
{
  FalconCalibration Calibration;
  /// The firmware's file; if empty, the environment's (FalconFirmware::PathOf).
  std::string FirmwarePath;
};

/// A Novint Falcon. Its frame: x to the user's right, y up, z towards the user, mm from the centre
/// of its workspace.
///
/// After power-up its encoders have no zero: it is in Homing, with a red light, until the user has
/// pulled the handle fully out and pushed it in; then the light is green. There is no force before,
/// nor while the newest position is older than 20 ms, nor if the counts have no position. It is
/// unknown whether the firmware drops a torque when it receives nothing, so nothing here relies on
/// it.
///
/// Apply returns false without an error while replies are outstanding or the link's queue is full:
/// the previous torque then persists, at most for LongestGap, after which the servo faults. A force
/// of 0 N overtakes both.
class FalconDevice final : public HapticDevice
{
public:
  /// Keeps the address of the clock. The calibration must have been checked.
  FalconDevice(Clock& clock, std::unique_ptr<FalconLink> link, FalconSettings settings);
  ~FalconDevice() override { this->FalconDevice::Close(); }

  const DeviceCapabilities& Capabilities() const noexcept override { return this->Abilities; }
  DeviceState State() const noexcept override { return this->Life.load(); }
  std::string Problem() const override;
  std::string Guidance() const override;
  std::string ConnectionReport() const override;
  Status Open() override;
  void Close() noexcept override;
  bool Read(DeviceSample& sample) noexcept override;
  bool Apply(const Vector3& force) noexcept override;

  /// Communication statistics since Open; only while no other thread reads or applies.
  const FalconStatistics& Statistics() const noexcept { return this->Exchange.Statistics(); }

private:
  enum class Fault
  {
    None,
    Unplugged,
    Silent,
    HomeLost
  };
  bool Fail(Fault fault) noexcept;
  bool IsInUse() const noexcept;
  void Forget() noexcept;
  void Measure(const FalconReply& reply, std::int64_t now) noexcept;
  // Returns false, and no torques, if the position is unknown.
  bool MotorsFor(const Vector3& force, std::int64_t now, FalconNumbers& motors) const noexcept;
  FalconDelivery SendMotors(const FalconNumbers& motors) noexcept;

  Clock& Time;
  std::unique_ptr<FalconLink> Link;
  FalconSettings Settings;
  FalconKinematics Kinematics;
  DeviceCapabilities Abilities;
  FalconBoot Boot;
  FalconExchange Exchange;
  HomingWatch Homing;

  std::atomic<DeviceState> Life{DeviceState::Closed};
  std::atomic<Fault> Failure{Fault::None};
  std::atomic<unsigned> HomedLegs{0}; // one bit per leg, from the newest reply
  DeviceSample Last;
  Vector3 Grip = Vector3::Zero(); // mm, from the base
  bool HasPosition = false;       // the newest counts have one
  bool HasLapsed = false;         // a force was not rendered, and 0 N was not requested since
  std::int64_t Measured = 0;      // ns, time of the counts
  unsigned Pressed = 0;           // buttons in the last reply, confirmed or not
};

/// Adds "falcon": real devices on USB (FalconKind with a LibusbFalconFinder). Only in builds with
/// libusb.
Status RegisterFalconDevices(DeviceRegistry& registry);
} // namespace palpate
