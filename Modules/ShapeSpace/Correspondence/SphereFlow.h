#pragma once

#include "SphericalHarmonicBasis.h"
#include "Vector3.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// A smooth one-to-one map of the unit sphere to itself: short steps, one after the other. A step
/// takes u to the direction of u + v(u), where v is the tangential part of a field of three
/// coordinates in spherical harmonics. By Bernstein's inequality v changes by at most (K + 2) times
/// its largest length per radian for harmonics up to degree K, so that a step of LongestStep can
/// neither fold the sphere nor tear it, and neither can any number of them.
class SphereFlow
{
public:
  /// One row per coordinate, one column per harmonic (SphericalHarmonicBasis).
  using Field = Eigen::Matrix<double, 3, Eigen::Dynamic>;

  /// The identity. `degree` >= 0, of the harmonics of its steps.
  explicit SphereFlow(int degree);

  int Degree() const noexcept { return this->Basis.Degree(); }
  bool IsIdentity() const noexcept { return this->Steps.empty(); }
  /// Half of what cannot fold, in rad.
  double LongestStep() const noexcept { return 0.5 / (this->Degree() + 2.0); }

  /// What comes last from now on. The caller keeps it as short as LongestStep.
  void Add(const Field& step) { this->Steps.push_back(step); }
  /// All steps become this times as long, 0 to 1.
  void Shorten(double share);

  /// Maps unit vectors. Allocates.
  void Map(std::vector<Vector3>& directions) const;
  /// The field's tangential part at unit vectors, rad. Allocates.
  std::vector<Vector3> TangentsOf(const Field& field, const std::vector<Vector3>& directions) const;
  /// Moves unit vectors along tangents.
  static void Move(const std::vector<Vector3>& tangents, double share,
                   std::vector<Vector3>& directions);

private:
  SphericalHarmonicBasis Basis;
  std::vector<Field> Steps;
};
} // namespace palpate
