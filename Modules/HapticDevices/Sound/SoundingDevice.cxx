#include "SoundingDevice.h"

namespace palpate
{
Status SoundingDevice::Open()
{
  Status status = this->Felt->Open();
  if (!status.IsOk())
  {
    return status;
  }
  this->Cues = {};
  this->Tone = {};
  this->Newest.Publish({});
  status = SdlLibrary::Load(this->Sdl);
  if (status.IsOk())
  {
    status = this->Sdl->Play(TouchTone::Rate, &SoundingDevice::Render, this, this->Player);
  }
  if (!status.IsOk())
  {
    this->Felt->Close();
  }
  return status;
}

void SoundingDevice::Silence() noexcept
{
  if (this->Player != 0)
  {
    this->Sdl->Silence(this->Player);
    this->Player = 0;
  }
}

void SoundingDevice::Close() noexcept
{
  this->Felt->Close(); // 0 N first
  this->Silence();
}

void SoundingDevice::Show(const TouchState& state) noexcept
{
  this->Felt->Show(state);
  this->Newest.Publish(this->Cues.Update(state));
}

void SoundingDevice::Render(void* owner, std::uint8_t* samples, int bytes)
{
  auto& self = *static_cast<SoundingDevice*>(owner);
  self.Tone.Render(self.Newest.Latest(), reinterpret_cast<float*>(samples),
                   static_cast<std::size_t>(bytes) / sizeof(float));
}
} // namespace palpate
