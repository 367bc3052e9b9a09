#pragma once

#include <array>
#include <vector>

namespace palpate
{
/// Replaces samples on a grid (i fastest, at least two along an axis) by the coefficients of the
/// cubic B-spline that interpolates them. Beyond the border the samples are mirrored at the last
/// one. Source: Unser, "Splines: a perfect fit for signal and image processing", IEEE Signal
/// Processing Magazine 16 (1999): a causal and an anticausal recursion along each axis.
void FindBSplineCoefficients(const std::array<int, 3>& size, std::vector<float>& samples);
} // namespace palpate
