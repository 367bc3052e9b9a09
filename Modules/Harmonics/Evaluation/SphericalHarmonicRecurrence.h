#pragma once

#include <cstddef>
#include <vector>

namespace palpate
{
/// Constants of the normalised recurrence for the real orthonormal spherical harmonics.
///
/// With Y_lm(u) = Q_l|m|(z) Re or Im (x + iy)^|m| (cosine for m >= 0, sine for m < 0), orthonormal
/// over the sphere and without the Condon-Shortley phase, the polynomials Q obey
///   Q_00 = 1 / sqrt(4 pi),  Q_mm = Q_(m-1)(m-1) sqrt((2m+1) / (2m)),  times sqrt(2) at m = 1,
///   Q_lm = a z Q_(l-1)m - a b Q_(l-2)m,  a = sqrt((4 l^2 - 1) / (l^2 - m^2)).
/// Near the poles that loses l^2 rounding errors, and the rounding of z even more. So it is applied
/// to the differences D_lm = Q_lm - r Q_(l-1)m from the values at the pole, with the
/// distance d = 1 - z = (x^2 + y^2) / (1 + z):
///   D_lm = g D_(l-1)m - a d Q_(l-1)m,  Q_lm = r Q_(l-1)m + D_lm,
///   r = a (l + m) / (2 l - 1),  g = a (l - 1 - m) / (2 l - 1).
/// In the south the same holds for -z, and Q_lm changes its sign if l - m is odd. No angle appears,
/// so the poles are ordinary points. Terms are stored order by order: all degrees of m = 0, then of
/// m = 1, and so on. Sources: Holmes and Featherstone, J. Geodesy 76 (2002), with sin^m divided
/// out; the differences as proposed by Reinsch: Deuflhard, Computing 17 (1976).
class SphericalHarmonicRecurrence
{
public:
  /// `degree` >= 0.
  explicit SphericalHarmonicRecurrence(int degree);

  struct Term
  {
    double Ratio; ///< r
    double Carry; ///< g
    double Slope; ///< a
  };

  int Degree() const noexcept { return this->MaximumDegree; }
  /// Q_mm, the start of the column of order m.
  double Diagonal(int order) const noexcept
  {
    return this->Diagonals[static_cast<std::size_t>(order)];
  }
  /// Terms of order m from degree m + 1 to the highest, in that order.
  const Term* Column(int order) const noexcept
  {
    const auto m = static_cast<std::ptrdiff_t>(order);
    return this->Terms.data() + m * this->MaximumDegree - m * (m - 1) / 2;
  }

private:
  int MaximumDegree;
  std::vector<double> Diagonals;
  std::vector<Term> Terms;
};
} // namespace palpate
