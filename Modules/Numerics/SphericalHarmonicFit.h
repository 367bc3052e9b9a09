#pragma once

#include "Status.h"
#include "Vector3.h"

#include <Eigen/Core>
#include <functional>
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

/// Settings of a fit.
struct SphericalHarmonicFitOptions
{
  enum class Penalty
  {
    None,
    Given,                     ///< strength is Roughness
    GeneralisedCrossValidation ///< strength chosen from the samples
  };

  int Degree = 12;
  Penalty PenaltyKind = Penalty::None;
  /// Strength of the penalty, see FitSphericalHarmonics. Used with Penalty::Given.
  double Roughness = 0.0;
  /// Without a penalty, a weighted design matrix with a larger condition number is refused: noise
  /// would be amplified by up to that factor where directions are missing.
  double MaximumCondition = 1e4;
  /// Asked now and then during long fits; true ends the fit with a failure.
  std::function<bool()> IsCancelled;
};

/// What a fit found. Lengths are mm.
struct SphericalHarmonicFitResult
{
  std::vector<double> Coefficients; ///< (degree + 1)^2, convention of SphericalHarmonicBasis
  std::vector<double> Residuals;    ///< sample minus model, one per sample
  double Condition = 0.0;           ///< 2-norm condition number of the weighted design matrix
  double Roughness = 0.0;           ///< strength of the penalty that was used
  double DegreesOfFreedom = 0.0;    ///< trace of the influence matrix
  double Rms = 0.0;                 ///< weighted root mean square of the residuals
  double NoiseDeviation = 0.0;      ///< estimated standard deviation of a sample of mean weight
  /// Entry l: weighted root mean square residual of the unpenalised fit of degree l, from the same
  /// factorisation. Empty with a penalty.
  std::vector<double> RmsByDegree;
  /// F with covariance of the coefficients = F F^T (mm^2).
  Eigen::MatrixXd CovarianceFactor;

  /// Standard deviation (mm) of the fitted radius where the harmonics have these values
  /// ((degree + 1)^2 of them).
  double RadiusDeviation(const double* basisValues) const;
};

/// Least-squares fit of R(u) = sum c_lm Y_lm(u) to samples: minimises
///   4 pi sum_i w_i (r_i - R(u_i))^2 / sum_i w_i  +  Roughness sum_lm (l (l+1))^2 c_lm^2,
/// whose second term is Roughness times the integral of the squared surface Laplacian of R.
/// Householder QR without a penalty; with one, the singular values of the projected problem in
/// standard form (Hansen, Rank-Deficient and Discrete Ill-Posed Problems, 1998, 2.3), which also
/// give the generalised cross-validation function (Golub, Heath and Wahba 1979) for every strength.
/// Fails, with a sentence, on fewer samples than coefficients, samples that are not finite,
/// weights that are negative or all zero, and a condition above the limit without a penalty.
Status FitSphericalHarmonics(const RadialSamples& samples,
                             const SphericalHarmonicFitOptions& options,
                             SphericalHarmonicFitResult& result);
} // namespace palpate
