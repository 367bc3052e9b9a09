#pragma once

#include <cstddef>
#include <vector>

/// Conversions between Palpate's coefficients (real, orthonormal, no Condon-Shortley phase, entry
/// l(l+1)+m) and other conventions. All are exact up to rounding and inverse to each other.
namespace palpate
{
/// SPHARM-PDM's order and scale: row l^2 is m = 0, rows l^2+2m-1 and l^2+2m are the cosine and the
/// sine part of order m; the basis has the Condon-Shortley sign (-1)^m and lacks the factor
/// sqrt(2) of m > 0, so its coefficients are sqrt(2) (-1)^m times ours. (Determined from real
/// files.)
std::vector<double> ToSpharmPdm(const std::vector<double>& coefficients);
std::vector<double> FromSpharmPdm(const std::vector<double>& rows);

/// The degree with coefficient count (L+1)^2 = `count`, or -1 if there is none.
int DegreeOfCount(std::size_t count) noexcept;
} // namespace palpate
