#pragma once

#include "DynamicLibrary.h"
#include "VendorArm.h"

#include <atomic>
#include <memory>
#include <thread>

namespace palpate
{
/// A device of Force Dimension by its SDK 3 (libdhd.so, or $PALPATE_LIBDHD): the few calls of its
/// reference that one arm needs, declared here. An arm shows torques (dhdHasActiveWrist), as
/// sigma.7 and lambda.7 do, if the library can say so. The controller's own limit of velocity and
/// its watchdog stay on. The SDK's frame has x towards the person, y to the right and z up.
class ForceDimensionArm final : public VendorArm
{
public:
  ForceDimensionArm();
  ~ForceDimensionArm() override { this->ForceDimensionArm::End(); }

  const DeviceCapabilities& Abilities() const noexcept override { return this->Known; }
  Status Open() override;
  Status Run(std::function<bool()> step) override;
  bool Measure(DeviceSample& sample) noexcept override;
  bool Push(const Vector3& force, const Vector3& torque) noexcept override;
  void End() noexcept override;
  std::string Trouble() const override;

private:
  struct Calls;

  DeviceCapabilities Known;
  std::unique_ptr<Calls> Dhd;
  int Device = -1;
  std::thread Thread;
};
} // namespace palpate
