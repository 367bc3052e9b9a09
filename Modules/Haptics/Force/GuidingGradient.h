#pragma once

#include "FeltImage.h"
#include "ForceEffect.h"
#include "ForceField.h"

#include <memory>

namespace palpate
{
/// How an image guides the tool.
struct GuidingSettings
{
  double FromIntensity = 0.0;
  double ToIntensity = 0.0;
  double Energy = 0.0;       ///< N mm from the one to the other
  double LargestForce = 0.5; ///< N
  double Fade = 10.0;        ///< mm inside the image's border where the force fades out
};

/// Guides the tool along the gradient of an image, from one intensity towards another: the
/// potential -E w s(I) has a smooth step s from 0 at the one to 1 at the other, and a weight w that
/// fades out at the image's border (FeltImage). So its force is 1.5 E / (difference of the
/// intensities) N per unit/mm half-way between both, falls to 0 at both, and is 0 where the image
/// is constant and outside it; towards the border, places near the second intensity are pulled
/// inwards. Nowhere is it larger than `LargestForce`: the energy is lowered until the steepest
/// place has that force, since cutting a force off would leave no potential. The image should be a
/// B-spline, whose gradient is continuous. Immutable, shared by threads.
class GuidingGradient final : public ForceEffect, public ForceField
{
public:
  /// Fails for a missing channel, equal intensities, an energy or a largest force that is not
  /// positive, and numbers that are not finite. Looks at every voxel.
  static Status Make(std::shared_ptr<const ScalarField> image, int channel,
                     const GuidingSettings& settings, std::shared_ptr<const GuidingGradient>& made);

  const ForceField* Field() const noexcept override { return this; }
  std::size_t Bytes() const noexcept override { return this->Image.Bytes(); }

  Vector3 ForceWorld(const Vector3& originWorld) const noexcept override;
  Eigen::AlignedBox3d BoundsWorld() const noexcept override;
  double Stiffness() const noexcept override { return this->Steepest; }
  /// N mm; at most that of the settings.
  double Energy() const noexcept { return this->Depth; }
  /// N mm, of the tool's origin at a place.
  double PotentialAt(const Vector3& originWorld) const noexcept;

private:
  GuidingGradient(const FeltImage& image, double largestForce)
      : Image(image), LargestForce(largestForce)
  {
  }
  Vector3 SlopeAt(const Vector3& originWorld) const noexcept;
  void FitInto(double energy);

  FeltImage Image;
  double LargestForce;   // N
  double Depth = 0.0;    // N mm, of the potential
  double Steepest = 0.0; // N/mm
};
} // namespace palpate
