#pragma once

#include "FieldSampler.h"
#include "ForceEffect.h"

#include <memory>

namespace palpate
{
/// What an image looks like, to be felt on a surface: a small force along the normal, larger where
/// the image is brighter than usual and smaller where it is darker. Immutable, shared by threads.
///
/// Of an intensity I it makes u / sqrt(1 + u^2), with u = (I - mean) / deviation, which is smooth
/// and lies within -1 and 1; of a push N by the structure, N A / (N + A) of that, which is less
/// than the amplitude A and less than N. So it begins with touch without a step, and never pulls.
/// It is no potential's: going in where it is soft and out where it is hard gives out energy, which
/// the energy observer sees.
class SurfaceTexture final : public ForceEffect
{
public:
  /// Mean and deviation are those of the channel within `boundsWorld` (mm), where the field should
  /// have samples everywhere (FieldBuilder::SetMargin). Refuses an amplitude (N) that is negative
  /// or not finite, a channel that the field does not have, and an image that has nothing to feel
  /// there.
  static Status Make(std::shared_ptr<const ScalarField> image, int channel,
                     const Eigen::AlignedBox3d& boundsWorld, double amplitude,
                     std::shared_ptr<const SurfaceTexture>& texture);

  /// Within -1 and 1; 0 where the image is as usual, and outside it.
  double BrightnessAt(const Vector3& pointWorld) const noexcept;
  /// N, to be added to a push of `push` >= 0 (N) along the normal, where the tool touches
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
