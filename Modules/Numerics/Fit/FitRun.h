#pragma once

#include "LeastSquaresSolver.h"
#include "RadialSamples.h"
#include "SphericalHarmonicFit.h"
#include "Status.h"

#include <vector>

namespace palpate
{
class HuberWeights;

/// The steps of FitSphericalHarmonics with one solver: condition, strength of the penalty,
/// solution, robust iterations, and the statistics of the result. Keeps references to its
/// arguments.
class FitRun
{
public:
  /// Samples and options must have been checked.
  FitRun(const RadialSamples& samples, const SphericalHarmonicFitOptions& options,
         LeastSquaresSolver& solver);

  Status Run(SphericalHarmonicFitResult& result);
  /// After Run: false if the solver gave up, so that another one may succeed.
  bool Able() const { return this->IsAble; }

private:
  SampleView View(const std::vector<double>& weights) const;
  bool IsPenalised() const;
  bool IsCancelled() const;
  bool FindStrength();
  CoefficientCovariance Covariance() const;
  double FinishCommon(const std::vector<double>& weights, SphericalHarmonicFitResult& result) const;
  Status Finish(SphericalHarmonicFitResult& result);
  void FindRmsByDegree(SphericalHarmonicFitResult& result) const;
  Status FinishRobust(SphericalHarmonicFitResult& result);
  Status FinishHuber(const HuberWeights& huber, const std::vector<double>& weights,
                     SphericalHarmonicFitResult& result);
  double RmsRadius() const;

  const RadialSamples& Samples;
  const SphericalHarmonicFitOptions& Settings;
  LeastSquaresSolver& Solver;
  std::vector<double> Weights; // normalised
  double Count;                // of samples with positive weight
  double Strength = 0.0;
  bool IsAble = true;
};
} // namespace palpate
