#pragma once

#include "DynamicLibrary.h"
#include "VendorArm.h"

#include <atomic>
#include <functional>
#include <memory>

namespace palpate
{
/// A device of 3D Systems by HDAPI of OpenHaptics 3 (libHD.so, or $PALPATE_LIBHD): the few calls of
/// its reference that one arm needs, declared here. An arm with six degrees of output, as a Phantom
/// Premium 6DOF, shows torques. Its limits of force and velocity stay on. Its frame is ours.
class OpenHapticsArm final : public VendorArm
{
public:
  /// The name under which its maker's set-up knows it; empty: the default device.
  explicit OpenHapticsArm(std::string name);
  ~OpenHapticsArm() override { this->OpenHapticsArm::End(); }

  const DeviceCapabilities& Abilities() const noexcept override { return this->Known; }
  Status Open() override;
  Status Run(std::function<bool()> step) override;
  bool Measure(DeviceSample& sample) noexcept override;
  bool Push(const Vector3& force, const Vector3& torque) noexcept override;
  void End() noexcept override;
  std::string Trouble() const override;

private:
  struct Error // HDErrorInfo
  {
    unsigned Code = 0;
    int Internal = 0;
    unsigned Device = 0;
  };
  using Handle = unsigned;
  using Callback = unsigned (*)(void*);
  struct Calls;

  void TakeAbilities();
  static unsigned StepOf(void* arm);

  std::string Name;
  DeviceCapabilities Known;
  std::unique_ptr<Calls> Hd;
  Handle Device;
  bool IsOpen = false;
  bool IsRunning = false;
  std::function<bool()> Step;
  std::atomic<bool> HasEnded{false};
  std::atomic<unsigned> Failure{0};
};
} // namespace palpate
