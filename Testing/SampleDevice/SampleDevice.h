#pragma once

#include "Clock.h"
#include "HapticDevice.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>

namespace palpate
{
/// The wire to the device of this example. A real back end has its library here (USB, serial port,
/// network); behind an interface it can be replaced in tests.
class SamplePort
{
public:
  struct Reply
  {
    std::array<std::int16_t, 3> Counts{}; // of the encoders
    bool IsHomed = false;
  };

  virtual ~SamplePort() = default;
  virtual bool Connect() = 0;
  virtual void Disconnect() noexcept = 0;
  /// Sends motor values and takes the reply of the packet before. Returns at once; false where the
  /// device does not answer any more.
  virtual bool Exchange(const std::array<std::int16_t, 3>& motors, Reply& reply) noexcept = 0;
};

/// An example of a back end, as Documentation/HowTo/AddADevice.md walks through it: a device with
/// three independent axes that talks over a SamplePort.
class SampleDevice final : public HapticDevice
{
public:
  SampleDevice(Clock& clock, std::unique_ptr<SamplePort> port);
  ~SampleDevice() override { this->SampleDevice::Close(); }

  const DeviceCapabilities& Capabilities() const noexcept override { return this->Abilities; }
  DeviceState State() const noexcept override { return this->Life; }
  std::string Problem() const override;
  Status Open() override;
  void Close() noexcept override;
  bool Read(DeviceSample& sample) noexcept override;
  bool Apply(const Vector3& force) noexcept override;

private:
  Clock& Time;
  std::unique_ptr<SamplePort> Port;
  DeviceCapabilities Abilities;
  std::atomic<DeviceState> Life{DeviceState::Closed};
  std::array<std::int16_t, 3> Motors{};
  DeviceSample Last;
};
} // namespace palpate
