#pragma once

#include "FieldSampler.h"
#include "ForceEffect.h"

#include <memory>

namespace palpate
{
/// Renders an image's intensity as texture of a surface: a small force along the normal, larger
/// where the image is brighter than average and smaller where it is darker. Immutable, shared by
/// threads.
///
/// An intensity I is mapped to u / sqrt(1 + u^2), with u = (I - mean) / deviation, which is smooth
/// and within -1 and 1; for a push N of the structure, the force is N A / (N + A) times that, which
/// is less than the amplitude A and less than N. So it starts without a step at contact, and never
/// pulls. It has no potential: entering where it is soft and leaving where it is hard generates
/// energy, which the energy observer detects.
class SurfaceTexture final : public ForceEffect
{
public:
  /// Mean and deviation are those of the channel within `boundsWorld` (mm), where the field should
  /// have samples everywhere (FieldBuilder::KeepAll). Fails for an amplitude (N) that is negative
  /// or not finite, a missing channel, and an image without contrast there.
  static Status Make(std::shared_ptr<const ScalarField> image, int channel,
                     const Eigen::AlignedBox3d& boundsWorld, double amplitude,
                     std::shared_ptr<const SurfaceTexture>& texture);

  /// Within -1 and 1; 0 where the image has its mean, and outside it.
  double BrightnessAt(const Vector3& pointWorld) const noexcept;
  /// N, to be added to a push of `push` >= 0 (N) along the normal, if the tool touches
  /// `pointWorld`.
  double PushAt(double push, const Vector3& pointWorld) const noexcept;
  Vector3 Force(const EffectTouch& touch) const noexcept override;
  std::size_t Bytes() const noexcept override;

private:
  SurfaceTexture(std::shared_ptr<const ScalarField> image, int channel, double amplitude);
  bool LearnUsual(const Eigen::AlignedBox3d& boundsWorld);

  FieldSampler Sampler;
  int Channel;
  double Amplitude; // N
  double Mean = 0.0;
  double Deviation = 1.0;
};
} // namespace palpate
