#pragma once

#include "FieldSampler.h"
#include "Status.h"

#include <memory>
#include <optional>

namespace palpate
{
/// An image as a level from 0 to 1 that forces can follow, with its gradient: linear between two
/// intensities, constant beyond them. A weight falls smoothly to 0 towards the image's border, so
/// that nothing steps where the image ends. Immutable, shared by threads.
class FeltImage
{
public:
  /// Gradients are per mm of the world.
  struct Place
  {
    double Level = 0.0;
    Vector3 LevelGradient = Vector3::Zero(); ///< 0 where the level is constant
    double Weight = 0.0;                     ///< 0 outside the image and on its border
    Vector3 WeightGradient = Vector3::Zero();
  };

  /// The level is 0 at the intensity `from` and 1 at `to`, which may be the smaller one. The weight
  /// is 1 from `fade` (mm) inside the border, but at most a quarter of the image's size. The field
  /// must have samples everywhere (FieldBuilder::KeepAll). Fails for a missing channel, and for
  /// intensities that are equal or not finite.
  static Status Make(std::shared_ptr<const ScalarField> image, int channel, double from, double to,
                     double fade, std::optional<FeltImage>& made);

  /// All 0 outside, and for a point that is not finite.
  Place At(const Vector3& pointWorld) const noexcept;
  const FieldGrid& Grid() const noexcept { return this->Sampler.Field().Grid(); }
  std::size_t Bytes() const noexcept { return this->Sampler.Field().Bytes(); }

private:
  FeltImage(std::shared_ptr<const ScalarField> image, int channel, double from, double to,
            double fade);
  void WeighAt(const Vector3& pointIndex, Place& place) const noexcept;

  FieldSampler Sampler;
  int Channel;
  double From;
  double To;
  Vector3 Fade; // voxels
};
} // namespace palpate
