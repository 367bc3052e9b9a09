#pragma once

#include "HapticDevice.h"
#include "LatestValue.h"
#include "SdlLibrary.h"
#include "TouchTone.h"

#include <memory>

namespace palpate
{
/// Another device whose touches are heard too (TouchTone), by the default output. Where there is
/// none, opening fails; everything else is the other device's.
class SoundingDevice final : public HapticDevice
{
public:
  explicit SoundingDevice(std::unique_ptr<HapticDevice> device) : Felt(std::move(device)) {}
  ~SoundingDevice() override { this->SoundingDevice::Close(); }

  const DeviceCapabilities& Capabilities() const noexcept override
  {
    return this->Felt->Capabilities();
  }
  DeviceState State() const noexcept override { return this->Felt->State(); }
  std::string Problem() const override { return this->Felt->Problem(); }
  std::string Guidance() const override { return this->Felt->Guidance(); }
  std::string ConnectionReport() const override { return this->Felt->ConnectionReport(); }
  Status Open() override;
  void Close() noexcept override;
  bool LeadHand(const Vector3& target) noexcept override { return this->Felt->LeadHand(target); }
  void TellDistance(double distance) noexcept override { this->Felt->TellDistance(distance); }
  bool Read(DeviceSample& sample) noexcept override { return this->Felt->Read(sample); }
  bool Apply(const Vector3& force) noexcept override { return this->Felt->Apply(force); }
  bool ApplyWrench(const Vector3& force, const Vector3& torque) noexcept override
  {
    return this->Felt->ApplyWrench(force, torque);
  }
  void Show(const TouchState& state) noexcept override;

private:
  static void Render(void* owner, std::uint8_t* samples, int bytes);
  void Silence() noexcept;

  std::unique_ptr<HapticDevice> Felt;
  std::shared_ptr<const SdlLibrary> Sdl;
  std::uint32_t Player = 0;     // 0: none
  LatestValue<TouchCue> Newest; // to SDL's thread
  TouchCues Cues;               // servo thread
  TouchTone Tone;               // SDL's thread
};
} // namespace palpate
