#pragma once

#include "DeviceCapabilities.h"
#include "DeviceSample.h"
#include "Status.h"

#include <functional>
#include <string>

namespace palpate
{
/// A device by its maker's library (VendorDevice). Frame: x to the right, y up, z towards the
/// person. Open, Run and End: owner thread; Measure and Push: within a step.
class VendorArm
{
public:
  VendorArm() = default;
  VendorArm(const VendorArm&) = delete;
  VendorArm& operator=(const VendorArm&) = delete;
  virtual ~VendorArm() = default;

  /// Known without a device; Open updates it.
  virtual const DeviceCapabilities& Abilities() const noexcept = 0;
  virtual Status Open() = 0;
  /// Calls `step` about once a millisecond on a thread of the arm, until it returns false.
  virtual Status Run(std::function<bool()> step) = 0;
  /// Place (mm), orientation and buttons. Returns false if the device failed.
  virtual bool Measure(DeviceSample& sample) noexcept = 0;
  /// Displays a force (N) and, if its MaximumTorque is above 0, a torque (N mm), once after each
  /// Measure. Returns false if the device failed.
  virtual bool Push(const Vector3& force, const Vector3& torque) noexcept = 0;
  /// Waits for the last step, and closes the device. No effect if it is not open.
  virtual void End() noexcept = 0;
  /// Of a device that failed: what its library said, and what to do.
  virtual std::string Trouble() const = 0;
};
} // namespace palpate
