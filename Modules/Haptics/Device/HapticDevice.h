#pragma once

#include "DeviceCapabilities.h"
#include "DeviceSample.h"
#include "DeviceState.h"
#include "Status.h"

#include <string>

namespace palpate
{
struct TouchState;

/// A device that measures the position of a hand and applies forces to it. Open, Close and Problem:
/// owner thread. Read and Apply: servo thread, between Open and Close. State: any thread.
///
///     Closed -> Opening -> Homing -> Ready -> Closed
///                  any of these -> Error -> Closed
///
/// Every back end must output 0 N by itself if Apply is no longer called.
class HapticDevice
{
public:
  HapticDevice() = default;
  HapticDevice(const HapticDevice&) = delete;
  HapticDevice& operator=(const HapticDevice&) = delete;
  /// The back end closes an open device.
  virtual ~HapticDevice() = default;

  /// Known before the device is opened, and updated by Open.
  virtual const DeviceCapabilities& Capabilities() const noexcept = 0;
  virtual DeviceState State() const noexcept = 0;
  /// Error message for the user; empty without an Error.
  virtual std::string Problem() const = 0;

  /// What the user should do now, for example during homing; empty if nothing. Owner thread, also
  /// while a servo runs.
  virtual std::string Guidance() const { return ""; }
  /// Quality of the connection since Open, as a message; empty if not measured. Owner thread, while
  /// no servo runs.
  virtual std::string ConnectionReport() const { return ""; }

  /// Leaves Closed. May take seconds; may end in Homing, which then ends while samples are read.
  virtual Status Open() = 0;
  /// Outputs 0 N first. No effect if closed.
  virtual void Close() noexcept = 0;

  /// Moves the hand of a simulated device to a place (mm, device's frame), or as near to it as the
  /// device reaches. Returns false, without effect, for a real device. Any thread.
  virtual bool LeadHand(const Vector3& target) noexcept
  {
    static_cast<void>(target);
    return false;
  }

  /// The distance (mm of the device) from the tool to the nearest structure, infinite if there is
  /// none, for devices that are slow near one. From a display, so some ticks old, or never called.
  /// Any thread.
  virtual void TellDistance(double distance) noexcept { static_cast<void>(distance); }

  /// The newest sample, which may be the previous one again. Returns false if the device failed.
  /// Never waits longer than a fraction of its own period.
  virtual bool Read(DeviceSample& sample) noexcept = 0;
  /// The force (N, in the device's frame) from now until the next call that returns true. Returns
  /// false if nothing was sent: the device failed, as State tells, or its connection is busy. The
  /// servo faults if that lasts longer than LongestGap.
  virtual bool Apply(const Vector3& force) noexcept = 0;
  /// The same with a torque (N mm, device's frame) about the origin of what it holds, for devices
  /// whose MaximumTorque is above 0. Apply alone takes the torque away.
  virtual bool ApplyWrench(const Vector3& force, const Vector3& torque) noexcept
  {
    static_cast<void>(torque);
    return this->Apply(force);
  }

  /// The tick whose force was applied, for devices that display more than a force. Servo thread,
  /// with the same requirements as Apply.
  virtual void Show(const TouchState& state) noexcept { static_cast<void>(state); }
};
} // namespace palpate
