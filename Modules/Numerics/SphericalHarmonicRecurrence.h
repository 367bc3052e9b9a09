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
///   Q_lm = a_lm (z Q_(l-1)m - b_lm Q_(l-2)m),
///   a_lm = sqrt((4 l^2 - 1) / (l^2 - m^2)),  b_lm = sqrt(((l-1)^2 - m^2) / (4 (l-1)^2 - 1)).
/// No angle appears, so the poles are ordinary points. Terms are stored order by order: all degrees
/// of m = 0, then of m = 1, and so on. Source: Holmes and Featherstone, J. Geodesy 76 (2002), with
/// sin^m divided out.
class SphericalHarmonicRecurrence
{
public:
  /// `degree` >= 0.
  explicit SphericalHarmonicRecurrence(int degree);

  struct Term
  {
    double A;
    double B;
  };

  int Degree() const noexcept { return this->MaximumDegree; }
  /// Q_mm, the start of the column of order m.
  double Diagonal(int order) const noexcept
  {
    return this->Diagonals[static_cast<std::size_t>(order)];
  }
  /// Terms of order m from degree m + 1 to the last, in that order.
  const Term* Column(int order) const noexcept
  {
    return this->Terms.data() + this->ColumnStart(order);
  }
  /// Where the column of `order` starts in an order-major array with one entry for each degree
  /// from m + 1 on.
  std::size_t ColumnStart(int order) const noexcept
  {
    return static_cast<std::size_t>(order) * static_cast<std::size_t>(this->MaximumDegree) -
           static_cast<std::size_t>(order) * static_cast<std::size_t>(order - 1) / 2;
  }

private:
  int MaximumDegree;
  std::vector<double> Diagonals;
  std::vector<Term> Terms;
};
} // namespace palpate
