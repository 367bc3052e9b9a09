#include "SurfaceTexture.h"

#include <cmath>
#include <utility>

namespace palpate
{
SurfaceTexture::SurfaceTexture(std::shared_ptr<const ScalarField> image, int channel,
                               double amplitude)
    : Sampler(std::move(image)), Channel(channel), Amplitude(amplitude)
{
}

Status SurfaceTexture::Make(std::shared_ptr<const ScalarField> image, int channel,
                            const Eigen::AlignedBox3d& boundsWorld, double amplitude,
                            std::shared_ptr<const SurfaceTexture>& texture)
{
  if (!(amplitude >= 0.0) || !std::isfinite(amplitude))
  {
    return Status::Failure("A texture's force must be finite and not negative.");
  }
  if (image == nullptr || channel < 0 || channel >= image->ChannelCount())
  {
    return Status::Failure("The texture has no image.");
  }
  // std::make_shared cannot call the private constructor.
  std::shared_ptr<SurfaceTexture> made(new SurfaceTexture(std::move(image), channel, amplitude));
  if (!made->LearnUsual(boundsWorld))
  {
    return Status::Failure("The image is constant at the structure, or does not reach it: there "
                           "is no texture to render.");
  }
  texture = std::move(made);
  return Status::Success();
}

// On a lattice of points, since the field stores its samples in bricks.
bool SurfaceTexture::LearnUsual(const Eigen::AlignedBox3d& boundsWorld)
{
  constexpr int Points = 32; // along each axis
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (int n = 0; n < Points * Points * Points; ++n)
  {
    const int row = n / Points;
    const int layer = row / Points;
    const Vector3 node(n % Points, row % Points, layer);
    const Vector3 place = (node.array() + 0.5) * boundsWorld.sizes().array() / Points;
    const FieldSample sample = this->Sampler.ValueWorld(this->Channel, boundsWorld.min() + place);
    if (sample.Kind != SampleKind::Outside)
    {
      // Relative to the first value, so that large intensities lose no digits.
      this->Mean = count == 0.0 ? sample.Value : this->Mean;
      const double above = sample.Value - this->Mean;
      count += 1.0;
      sum += above;
      squares += above * above;
    }
  }
  this->Mean += sum / count;
  this->Deviation = std::sqrt(squares / count - (sum / count) * (sum / count));
  return this->Deviation > 0.0 && std::isfinite(this->Mean) && std::isfinite(this->Deviation);
}

double SurfaceTexture::BrightnessAt(const Vector3& pointWorld) const noexcept
{
  const FieldSample sample = this->Sampler.ValueWorld(this->Channel, pointWorld);
  const double u = (sample.Value - this->Mean) / this->Deviation;
  const double brightness = u / std::hypot(1.0, u);
  return sample.Kind != SampleKind::Outside && std::isfinite(brightness) ? brightness : 0.0;
}

double SurfaceTexture::PushAt(double push, const Vector3& pointWorld) const noexcept
{
  if (!(push > 0.0) || !(this->Amplitude > 0.0))
  {
    return 0.0;
  }
  return push * (this->Amplitude / (push + this->Amplitude)) * this->BrightnessAt(pointWorld);
}

Vector3 SurfaceTexture::Force(const EffectTouch& touch) const noexcept
{
  if (!touch.Contact.IsTouching)
  {
    return Vector3::Zero();
  }
  const double push = touch.ContactForce.dot(touch.Contact.Normal);
  return this->PushAt(push, touch.SurfaceWorld) * touch.Contact.Normal;
}

std::size_t SurfaceTexture::Bytes() const noexcept
{
  return this->Sampler.Field().Bytes();
}
} // namespace palpate
