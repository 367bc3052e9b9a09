#pragma once

#include "CheckedMask.h"
#include "Vector3.h"

#include <Eigen/Core>
#include <vector>

namespace palpate
{
/// The outline of a mask from its centroid: the logarithm of the radius (mm) as spherical
/// harmonics.
struct RadialOutline
{
  Vector3 CenterWorld = Vector3::Zero(); ///< the centroid, mm
  Eigen::VectorXd Coefficients;          ///< of ln(radius / mm), SphericalHarmonicBasis
  double Residual = 0.0;           ///< RMS of ln(radius) over the directions, from the harmonics
  Vector3 Rough = Vector3::Zero(); ///< where that is largest, world
  double Missed = 0.0;             ///< share of the directions along which the mask does not lie
};

/// Measures outlines along 642 directions of the patient's axes; degree 12. The outermost crossing
/// counts; along directions that miss the mask the radius is a tenth of that of the ball of the
/// mask's volume, so that bodies which their centroid does not see have an outline, too.
class RadialProbe
{
public:
  static constexpr int Degree = 12;

  RadialProbe();

  const std::vector<Vector3>& Directions() const noexcept { return this->Rays; }
  /// The harmonics at the directions, a row each.
  const Eigen::MatrixXd& Basis() const noexcept { return this->Harmonics; }

  /// `signedDepths` (mm): positive inside (SignedDistance). Const and thread-safe.
  RadialOutline Measure(const CheckedMask& part, const std::vector<float>& signedDepths) const;

private:
  std::vector<Vector3> Rays;
  Eigen::MatrixXd Harmonics;
  Eigen::MatrixXd Inverse; // least squares
};
} // namespace palpate
