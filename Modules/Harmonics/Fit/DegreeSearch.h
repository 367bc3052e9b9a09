#pragma once

#include "RadialModelFit.h"
#include "RadialSamples.h"
#include "Status.h"

namespace palpate
{
/// Which degree is wanted: the smallest from Least on whose root mean square residual is at most
/// the tolerance.
struct DegreeSearch
{
  double Tolerance = 0.0; ///< mm
  int Least = 0;          ///< a search does not take a lower degree, even beyond Supported
  int Maximum = 40;
  /// The highest degree that the samples can determine. A search that reaches it ends there, even
  /// if the tolerance is not met.
  int Supported = 1000;
};

/// Searches by the residuals of plain fits, whatever penalty and weights `options` have. Fails as
/// FitRadialModel and if no degree up to the maximum meets the tolerance.
Status FindDegree(const RadialSamples& samples, RadialModelFitOptions options,
                  const DegreeSearch& search, int& found);
} // namespace palpate
