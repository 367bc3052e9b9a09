#pragma once

#include "Clock.h"
#include "HapticDevice.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>

namespace palpate
{
/// The wire to the example device. A real back end calls its library here (USB, serial port,
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
  /// Sends motor values and receives the reply to the previous packet. Returns at once; false if
  /// the device no longer answers.
  virtual bool Exchange(const std::array<std::int16_t, 3>& motors, Reply& reply) noexcept = 0;
};

/// Example of a back end, explained in Documentation/HowTo/AddADevice.md: a device with three
/// independent axes that communicates over a SamplePort.
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
