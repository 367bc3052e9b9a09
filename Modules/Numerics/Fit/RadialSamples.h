#pragma once

#include "Status.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// Radii seen along directions, and how much each counts.
struct RadialSamples
{
  std::vector<Vector3> Directions; ///< unit vectors
  std::vector<double> Radii;       ///< mm
  std::vector<double> Weights;     ///< >= 0, e.g. solid angles; only their ratios matter
};

/// Refuses, with a sentence, samples from which no fit of `degree` can follow: a negative degree,
/// arrays of different length, numbers that are not finite, negative weights, and fewer samples of
/// positive weight than coefficients.
Status CheckSamples(const RadialSamples& samples, int degree);

/// How many samples have a positive weight.
std::size_t CountWeighted(const std::vector<double>& weights);

/// The weights over their sum, times 4 pi: solid angles, as the fits use them. Large or tiny
/// weights do not overflow.
std::vector<double> NormalisedWeights(const std::vector<double>& weights);
} // namespace palpate
