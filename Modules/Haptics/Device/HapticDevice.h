#pragma once

#include "DeviceCapabilities.h"
#include "DeviceSample.h"
#include "DeviceState.h"
#include "Status.h"

#include <string>

namespace palpate
{
/// A device that measures where a hand is and pushes it. Open, Close and Problem are for the thread
/// that owns it; Read and Apply are for the servo thread, between them; State is for any.
///
///     Closed -> Opening -> Homing -> Ready -> Closed
///                  any of these -> Error -> Closed
///
/// Every back end must give 0 N by itself where nothing calls Apply any more.
class HapticDevice
{
public:
  HapticDevice() = default;
  HapticDevice(const HapticDevice&) = delete;
  HapticDevice& operator=(const HapticDevice&) = delete;
  /// Of an open one: the back end closes it.
  virtual ~HapticDevice() = default;

  /// Known before it is opened, and as it stands after.
  virtual const DeviceCapabilities& Capabilities() const noexcept = 0;
  virtual DeviceState State() const noexcept = 0;
  /// What an Error is, in one sentence for the person at the device; empty without.
  virtual std::string Problem() const = 0;

  /// What the person at it should do now, as while it is homed; empty where nothing. For the
  /// owner's thread, beside a servo too.
  virtual std::string Guidance() const { return ""; }
  /// How its connection has done since it was opened, in one sentence; empty where nobody counts.
  /// For the owner's thread, while no servo runs.
  virtual std::string ConnectionReport() const { return ""; }

  /// Takes it out of Closed. May take seconds; may end in Homing, which then ends while samples
  /// are read.
  virtual Status Open() = 0;
  /// Gives 0 N first. Nothing where it is closed.
  virtual void Close() noexcept = 0;

  /// Leads the hand of a simulated device to a place (mm, device's frame), or as near to it as the
  /// device reaches. False, without effect, for a device with a hand of its own. For any thread.
  virtual bool LeadHand(const Vector3& target) noexcept
  {
    static_cast<void>(target);
    return false;
  }

  /// The newest sample; the same as before where there is no newer one. False where the device
  /// failed. Never waits for longer than a fraction of its own period.
  virtual bool Read(DeviceSample& sample) noexcept = 0;
  /// The force (N, in the device's frame) from now until the next call that returns true. False
  /// where nothing was sent: the device failed, which State says, or its connection takes nothing
  /// just now. The servo faults where that lasts for longer than LongestGap.
  virtual bool Apply(const Vector3& force) noexcept = 0;
};
} // namespace palpate
