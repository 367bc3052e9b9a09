#pragma once

#include "RadialModel.h"
#include "RadialSamples.h"

#include <string>
#include <vector>

namespace palpate::test
{
/// Difficult sets of directions for a fit of degree 12, each with a weight.
struct HardDirections
{
  std::string Name;
  std::vector<Vector3> Directions;
  std::vector<double> Weights;
};

/// The 1,442 directions of an icosahedron without caps of 0 to 60 and of 90 degrees around +z,
/// weighted by solid angle; nine in ten within 20 degrees of +z; each of 362 up to ten times; as
/// many as there are coefficients.
std::vector<HardDirections> AllHardDirections();

/// Samples of an organ of degree 12 along directions, without noise.
RadialSamples SamplesAlong(const HardDirections& hard, const RadialModel& organ);

/// Effect of rounding alone on a fit of an organ of degree 12, of 20 mm: the largest difference
/// (mm) over the whole sphere between the fitted radius and that of exact arithmetic.
struct FitPrecision
{
  std::string Directions;
  double Roughness = 0.0; ///< of the penalty
  double Condition = 0.0; ///< without it
  ///@{ Eigen's LLT and HouseholderQR in single precision; not-a-number where they failed.
  double FloatNormalEquations = 0.0;
  double FloatOrthogonal = 0.0;
  ///@}
  double DoubleNormalEquations = 0.0; ///< Eigen's LLT
  double Ours = 0.0;                  ///< FitRadialModel
};

/// One row for each set of directions, without a penalty and with a typical one. The exact result
/// is the organ itself without a penalty, else an orthogonal factorisation in long double. Takes
/// seconds.
std::vector<FitPrecision> MeasureFitPrecision();

/// The rows as a table in Markdown.
std::string ToMarkdown(const std::vector<FitPrecision>& rows);
} // namespace palpate::test
