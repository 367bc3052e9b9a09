#pragma once

#include "CoefficientCovariance.h"
#include "RadialSamples.h"
#include "Status.h"

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace palpate
{
struct RadialModelFitOptions
{
  enum class Penalty
  {
    None,
    Given,                     ///< strength is Roughness
    GeneralisedCrossValidation ///< strength chosen from the samples
  };
  enum class Robust
  {
    None,
    Huber ///< reduces the weight of samples with large residuals, see HuberWeights
  };

  int Degree = 12;
  Penalty PenaltyKind = Penalty::None;
  /// Strength of the penalty for Penalty::Given, see FitRadialModel.
  double Roughness = 0.0;
  /// Without a penalty, a weighted design matrix with a larger condition number is refused: noise
  /// would be amplified by up to that factor where directions are missing.
  double MaximumCondition = 1e4;
  Robust RobustKind = Robust::None;
  /// Polled during long fits; true ends the fit with a failure.
  std::function<bool()> IsCancelled;
};

/// Result of a fit. Lengths are mm.
struct RadialModelFitResult
{
  std::vector<double> Coefficients; ///< (degree + 1)^2, convention of SphericalHarmonicBasis
  std::vector<double> Residuals;    ///< sample minus model, one per sample
  /// 2-norm condition number of the weighted design matrix, see EstimateCondition.
  double Condition = 0.0;
  double Roughness = 0.0;        ///< strength of the penalty that was used
  double DegreesOfFreedom = 0.0; ///< trace of the influence matrix
  double Rms = 0.0;              ///< weighted root mean square of the residuals
  /// Estimated standard deviation of a sample of mean weight; the scale of HuberWeights if robust.
  double NoiseDeviation = 0.0;
  /// Entry l: weighted root mean square residual of the unpenalised fit of degree l, from the same
  /// factorisation. Empty with a penalty and for a robust fit.
  std::vector<double> RmsByDegree;
  /// Robust fit: the factor in (0, 1] of each sample's weight; otherwise empty.
  std::vector<double> RobustFactors;
  std::size_t DownWeighted = 0; ///< number of factors below 1
  /// Gives the standard deviation of the radius.
  CoefficientCovariance Covariance;
};

/// Least-squares fit of R(u) = sum c_lm Y_lm(u) to samples: minimises
///   4 pi sum_i w_i (r_i - R(u_i))^2 / sum_i w_i  +  Roughness sum_lm (l (l+1))^2 c_lm^2,
/// whose second term is Roughness times the integral of the squared surface Laplacian of R.
/// By moments of the samples and Cholesky's method with iterative refinement (MomentSolver) up to a
/// condition of 1e6, else by a Householder factorisation (OrthogonalSolver); both agree to the
/// rounding of the radii times the condition. Generalised cross-validation: see CrossValidation.
///
/// A robust fit iterates with new weights until the radius changes by less than a ten-thousandth of
/// the noise (rms), at most 50 times; after ten iterations the scale and the strength are fixed, so
/// that each further step lowers one convex function.
///
/// Fails, with a one-sentence message, for fewer samples than coefficients, non-finite samples,
/// weights that are negative or all zero, and a condition above the limit without a penalty.
Status FitRadialModel(const RadialSamples& samples, const RadialModelFitOptions& options,
                      RadialModelFitResult& result);
} // namespace palpate
