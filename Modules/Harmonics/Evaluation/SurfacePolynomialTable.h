#pragma once

#include "CacheLineVector.h"

#include <array>

namespace palpate
{
/// The coefficients of three coordinates as polynomials, for the evaluation kernels: the E_m and
/// O_m of PolynomialTable, which see. Good to 1e-12 up to HighestSurfacePolynomialDegree.
///
/// Layout, always from the highest power down. First order 0, degree / 2 + 1 rows: x, y, z and 0 of
/// E_0, then of O_0. Then pairs of orders (m, m + 1) with odd m, from the highest down: rows of
/// twelve numbers, for each of x, y and z the cosine and sine terms of m, then those of m + 1; rows
/// of E, then as many of O, with zeros for terms that do not exist. 4.4 KB at degree 12, 11 KB at
/// degree 20.
///
/// `coefficients` have (degree + 1)^2 entries each in the convention of SphericalHarmonicBasis;
/// degree even and >= 0.
CacheLineVector<double>
MakeSurfacePolynomialTable(int degree, const std::array<std::vector<double>, 3>& coefficients);
} // namespace palpate
