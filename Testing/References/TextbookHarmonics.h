#pragma once

#include "Vector3.h"

#include <complex>

namespace palpate::test
{
/// The slow, obvious harmonics of the textbooks, in long double: associated Legendre functions with
/// factorial normalisation and angles. The oracle of the fast code; shares nothing with it.

/// Complex orthonormal Y_lm with the Condon-Shortley phase, m >= 0.
std::complex<long double> TextbookComplex(int degree, int order, const Vector3& direction);
/// Real orthonormal Y_lm without the phase; m > 0 is the cosine, m < 0 the sine.
long double TextbookReal(int degree, int order, const Vector3& direction);
} // namespace palpate::test
