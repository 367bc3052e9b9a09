#pragma once

#include "CacheLineVector.h"

namespace palpate
{
/// The coefficients of a radius function, or of several functions that are evaluated together,
/// interleaved with the constants of
/// SphericalHarmonicRecurrence, for the evaluation kernels.
///
/// Layout: blocks of four consecutive orders, starting at order 0. A block of lowest order f has a
/// first row of four numbers, one for each order, of each of these: Q_mm, and every function's
/// cosine and sine coefficient of degree m. Then one row for each further degree, up to degree - f
/// of them: ratio, carry, slope, and the coefficients of degree m + k. Entries that do not exist
/// are zero.
///
/// Every vector of `functions` has (degree + 1)^2 entries in the convention of
/// SphericalHarmonicBasis; degree >= 0.
CacheLineVector<double> MakeRecurrenceTable(int degree,
                                            const std::vector<std::vector<double>>& functions);
} // namespace palpate
