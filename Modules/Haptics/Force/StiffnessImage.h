#pragma once

#include "FeltImage.h"
#include "ForceEffect.h"

#include <memory>

namespace palpate
{
/// Stiffnesses at two intensities of an image.
struct StiffnessRange
{
  double FromIntensity = 0.0;
  double ToIntensity = 0.0;
  double FromStiffness = 0.0; ///< N/mm at the hand
  double ToStiffness = 0.0;   ///< N/mm at the hand
};

/// A rigid structure's stiffness follows an image where the tool touches: linear between two
/// intensities, constant beyond them, and the structure's own outside the image, towards whose
/// border it blends. Structures that yield have a stiffness of their own and are not affected.
/// Immutable, shared by threads.
///
/// The contact's spring then has the energy k(s) d^2 / 2 for a depth d at a point s of the surface.
/// Besides its push k d it resists motion along the surface towards stiffer places with the force
/// -grad k(s) d^2 / 2, without which a hand could press where it is soft, leave where it is stiff,
/// and gain energy. On a plane, without friction, the sum is exactly the gradient of the energy. On
/// a surface of curvature radius R, where s moves by R / (R + h) of the hand's motion for a tool's
/// centre at a height h, a closed path gains at most |h| / (R + h) of the change of energy; the
/// energy observer sees that.
class StiffnessImage final : public ForceEffect
{
public:
  /// At the image's border, within which the stiffness blends into the structure's own: times the
  /// largest spacing.
  static constexpr double FadeVoxels = 2.0;

  /// Fails for a missing channel, equal intensities, negative stiffnesses, and numbers that are not
  /// finite. The field must have samples everywhere (FieldBuilder::KeepAll).
  static Status Make(std::shared_ptr<const ScalarField> image, int channel,
                     const StiffnessRange& range, std::shared_ptr<const StiffnessImage>& made);

  double StiffnessAt(double own, const Vector3& pointWorld) const noexcept override;
  double LargestStiffness(double own) const noexcept override;
  /// Only the force along the surface: the stiffness changes the contact's own force.
  Vector3 Force(const EffectTouch& touch) const noexcept override;
  std::size_t Bytes() const noexcept override { return this->Image.Bytes(); }

private:
  StiffnessImage(const FeltImage& image, const StiffnessRange& range) : Image(image), Range(range)
  {
  }
  double StiffnessOf(const FeltImage::Place& place) const noexcept;

  FeltImage Image;
  StiffnessRange Range;
};
} // namespace palpate
