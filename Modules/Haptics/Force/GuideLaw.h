#pragma once

#include "GuideSettings.h"

namespace palpate
{
/// The law of all guides: at the distance D (mm) within the range R, the force k D (1 - D^2/R^2)^2
/// with the potential -k R^2 (1 - D^2/R^2)^3 / 6. So it is a spring of stiffness k at the guide,
/// largest at R / sqrt(5) with 0.286 k R, and ends smoothly at R.
class GuideLaw
{
public:
  /// Lowers the stiffness until the force is at most the largest one where the distance changes by
  /// `steepest` per mm.
  explicit GuideLaw(const GuideSettings& settings, double steepest = 1.0);

  /// N per mm of the distance; 0 out of range, and for a distance that is not a number.
  double PullAt(double squaredDistance) const noexcept;
  /// N mm; 0 out of range.
  double PotentialAt(double squaredDistance) const noexcept;

  double Range() const noexcept { return this->Reach; }      ///< mm
  double Stiffness() const noexcept { return this->Spring; } ///< N/mm, at the guide
  double LargestForce() const noexcept;                      ///< N, per mm of distance and mm
  /// N mm, from the guide to the range.
  double Energy() const noexcept { return this->Spring * this->Reach * this->Reach / 6.0; }

private:
  double Left(double squaredDistance) const noexcept;

  double Reach;
  double Spring;
};
} // namespace palpate
