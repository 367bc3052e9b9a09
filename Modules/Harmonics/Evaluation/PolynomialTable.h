#pragma once

#include "CacheLineVector.h"

namespace palpate
{
/// The coefficients of a radius function as polynomials, for the evaluation kernels.
///
/// With w = x + iy and t = 1 - 2 (x^2 + y^2) = 2 z^2 - 1 on the unit sphere,
///   R(u) = Re sum_m conj(D_m(z)) w^m,   D_m(z) = E_m(t) + z O_m(t),
/// where E_m and O_m have complex coefficients (cosine plus i sine terms) and at most half the
/// degree. t runs over [-1, 1], where these power sums are well conditioned: a term of degree n
/// grows by at most (1 + sqrt 2)^n. Good to about degree 16.
///
/// Layout, always from the highest power down. First order 0 as four real polynomials in t^2 with
/// degree / 4 + 1 coefficients each, side by side: the even and the odd powers of E_0, the even and
/// the odd powers of O_0. Then blocks of four consecutive orders, from order 1 on; in a block, for
/// each power four cosine and four sine coefficients of E, then the same of O, with zeros for
/// orders that have no such term or do not exist. 1.7 KB at degree 12.
///
/// `coefficients` has (degree + 1)^2 entries in the convention of SphericalHarmonicBasis; degree >=
/// 0. The polynomials are made in long double and rounded once.
CacheLineVector<double> MakePolynomialTable(int degree, const std::vector<double>& coefficients);
} // namespace palpate
