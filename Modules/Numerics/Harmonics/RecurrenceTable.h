#pragma once

#include "CacheLineVector.h"

namespace palpate
{
/// The coefficients of a radius function, interleaved with the constants of
/// SphericalHarmonicRecurrence, for the evaluation kernels.
///
/// Layout: blocks of four consecutive orders, starting at order 0. A block of lowest order f has a
/// first row of three times four numbers, one for each order: Q_mm, and the cosine and sine
/// coefficients of degree m. Then one row of five times four for each further degree, up to degree
/// - f of them: ratio, carry, slope, cosine and sine coefficient of degree m + k. Entries that do
/// not exist are zero.
///
/// `coefficients` has (degree + 1)^2 entries in the convention of SphericalHarmonicBasis; degree >=
/// 0.
CacheLineVector<double> MakeRecurrenceTable(int degree, const std::vector<double>& coefficients);
} // namespace palpate
