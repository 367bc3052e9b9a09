#pragma once

#include <complex>
#include <vector>

/// Conversions between Palpate's coefficients (real, orthonormal, no Condon-Shortley phase, entry
/// l(l+1)+m) and other conventions. All are exact up to rounding and inverse to each other.
namespace palpate
{
/// Complex coefficients r_lm, m = 0..l only (a real function has r_l,-m = (-1)^m conj(r_lm)), of
/// the complex orthonormal harmonics with the Condon-Shortley phase, in the order (0,0), (1,0),
/// (1,1), (2,0) ...: r_lm = (-1)^m (c_lm - i c_l,-m) / sqrt(2) for m > 0, r_l0 = c_l0.
std::vector<std::complex<double>> ToComplex(const std::vector<double>& coefficients);
std::vector<double> FromComplex(const std::vector<std::complex<double>>& coefficients);

/// SPHARM-PDM's order and scale: row l^2 is m = 0, rows l^2+2m-1 and l^2+2m are the cosine and the
/// sine part of order m; the basis has the Condon-Shortley sign (-1)^m and lacks the factor
/// sqrt(2) of m > 0, so its coefficients are sqrt(2) (-1)^m times ours. (Determined from real
/// files.)
std::vector<double> ToSpharmPdm(const std::vector<double>& coefficients);
std::vector<double> FromSpharmPdm(const std::vector<double>& rows);

/// The degree with coefficient count (L+1)^2 = `count`, or -1 if there is none.
int DegreeOfCount(std::size_t count) noexcept;
} // namespace palpate
