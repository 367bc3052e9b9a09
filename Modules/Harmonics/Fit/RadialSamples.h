#pragma once

#include "Status.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
struct RadialSamples
{
  std::vector<Vector3> Directions; ///< unit vectors
  std::vector<double> Radii;       ///< mm
  std::vector<double> Weights;     ///< >= 0, e.g. solid angles; only their ratios matter
};

/// Fails for samples that cannot determine a fit of `degree`: a negative degree, arrays of
/// different length, non-finite numbers, negative weights, and fewer samples of positive weight
/// than coefficients.
Status CheckSamples(const RadialSamples& samples, int degree);

/// Number of samples with positive weight.
std::size_t CountWeighted(const std::vector<double>& weights);

/// The weights divided by their sum, times 4 pi: solid angles, as the fits use them. Very large or
/// small weights do not overflow.
std::vector<double> NormalisedWeights(const std::vector<double>& weights);
} // namespace palpate
