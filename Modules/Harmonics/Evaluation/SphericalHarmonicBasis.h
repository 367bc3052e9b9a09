#pragma once

#include "SphericalHarmonicRecurrence.h"
#include "Vector3.h"

#include <cstddef>

namespace palpate
{
/// All real spherical harmonics up to a degree at one direction.
///
/// Convention (the same everywhere in Palpate): real, orthonormal over the unit sphere, no
/// Condon-Shortley phase, polar axis +z, entry l(l+1)+m for degree l and order m; m > 0 carries
/// cos(m phi), m < 0 carries sin(|m| phi). So Y_1,-1 : Y_1,0 : Y_1,1 = y : z : x.
class SphericalHarmonicBasis
{
public:
  /// `degree` >= 0.
  explicit SphericalHarmonicBasis(int degree) : Recurrence(degree) {}

  int Degree() const noexcept { return this->Recurrence.Degree(); }
  /// (degree + 1)^2.
  std::size_t Size() const noexcept { return CoefficientCount(this->Degree()); }

  static constexpr std::size_t CoefficientCount(int degree) noexcept
  {
    return static_cast<std::size_t>(degree + 1) * static_cast<std::size_t>(degree + 1);
  }
  static constexpr std::size_t Index(int degree, int order) noexcept
  {
    return static_cast<std::size_t>(degree * (degree + 1) + order);
  }

  /// Writes Size() values for `direction`, normalised exactly (NaN if it is zero). Accurate to
  /// 1e-14 of the largest harmonic at degree 12 and to 1e-12 at degree 1000, including the poles.
  /// Does not allocate; const and thread-safe.
  void Evaluate(const Vector3& direction, double* values) const noexcept;

private:
  SphericalHarmonicRecurrence Recurrence;
};
} // namespace palpate
