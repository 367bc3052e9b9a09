#pragma once

#include "DeviceRegistry.h"
#include "HapticDevice.h"
#include "Inverse3Client.h"

#include <cstdint>
#include <memory>
#include <string>

namespace palpate
{
/// A Haply Inverse3, 3x or Minverse by its maker's service on this machine, with the orientation of
/// a VerseGrip where there is one. Homing until the service displays forces. It is tested against
/// virtual services only, never on hardware.
class Inverse3Device final : public HapticDevice
{
public:
  /// Keeps the address of the clock, which must outlive it.
  Inverse3Device(Clock& clock, Inverse3Address address);
  ~Inverse3Device() override { this->Inverse3Device::Close(); }

  const DeviceCapabilities& Capabilities() const noexcept override { return this->Abilities; }
  DeviceState State() const noexcept override { return this->Shared.Life.load(); }
  std::string Problem() const override;
  std::string Guidance() const override;
  std::string ConnectionReport() const override;
  Status Open() override;
  void Close() noexcept override;
  bool Read(DeviceSample& sample) noexcept override;
  bool Apply(const Vector3& force) noexcept override;

private:
  Clock& Time;
  Inverse3Address Address;
  DeviceCapabilities Abilities;
  Inverse3Exchange Shared;
  std::unique_ptr<Inverse3Client> Client;
  std::uint64_t Commands = 0; // servo thread
};

/// Adds "inverse3" and "inverse3:ID".
Status RegisterInverse3Devices(DeviceRegistry& registry);
} // namespace palpate
