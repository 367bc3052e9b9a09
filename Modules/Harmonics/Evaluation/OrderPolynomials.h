#pragma once

#include <vector>

namespace palpate
{
/// E(t) + z O(t) with t = 2 z^2 - 1, by coefficients of increasing powers of t.
struct ParityPolynomial
{
  std::vector<long double> Even;
  std::vector<long double> Odd;
};

/// The sums of one order over the degrees: D_m of PolynomialTable, its real and imaginary part.
struct OrderPolynomials
{
  ParityPolynomial Cosine;
  ParityPolynomial Sine;
};

/// Sums c_lm Q_lm(z) over the degrees of one order by the recurrence, on polynomials.
/// `coefficients` has (degree + 1)^2 entries in the convention of SphericalHarmonicBasis.
OrderPolynomials SumOrder(int degree, int order, const std::vector<double>& coefficients);

/// The coefficient of a power, 0 if the polynomial does not have it.
double PolynomialTerm(const std::vector<long double>& polynomial, int power);
} // namespace palpate
