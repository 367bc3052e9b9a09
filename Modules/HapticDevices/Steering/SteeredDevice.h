#pragma once

#include "HapticDevice.h"
#include "SimulatedDevice.h"
#include "SteeredPose.h"

#include <atomic>
#include <limits>
#include <memory>

namespace palpate
{
/// A computed hand (SimulatedDevice) that a source steers: it meets the scene's forces, so that it
/// stops at surfaces and slides along them; the person sees that, and feels what the source tells.
/// No force reaches a person.
class SteeredDevice final : public HapticDevice
{
public:
  /// Keeps the address of the clock, which must outlive it.
  SteeredDevice(Clock& clock, std::unique_ptr<SteeringSource> source);
  ~SteeredDevice() override { this->SteeredDevice::Close(); }

  const DeviceCapabilities& Capabilities() const noexcept override { return this->Abilities; }
  DeviceState State() const noexcept override;
  std::string Problem() const override;
  Status Open() override;
  void Close() noexcept override;
  bool Read(DeviceSample& sample) noexcept override;
  bool Apply(const Vector3& force) noexcept override;
  void Show(const TouchState& state) noexcept override;
  void TellDistance(double distance) noexcept override { this->Told.store(distance); }

private:
  double DistanceNow(const Vector3& handDevice) noexcept;

  std::unique_ptr<SteeringSource> Source;
  SimulatedDevice Hand;
  DeviceCapabilities Abilities;
  std::atomic<bool> HasFailed{false};
  std::atomic<double> Told{std::numeric_limits<double>::quiet_NaN()}; // mm; NaN when taken
  double Distance = std::numeric_limits<double>::infinity();          // mm, when it was told
  Vector3 ToldAt = Vector3::Zero();                                   // the hand then
  SteeredPose Steered;
  DeviceSample Last;
};
} // namespace palpate
