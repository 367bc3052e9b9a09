#pragma once

#include "LeastSquaresSolver.h"
#include "RadialModelFit.h"
#include "RadialSamples.h"
#include "Status.h"

#include <vector>

namespace palpate
{
class HuberWeights;

/// The steps of FitRadialModel with one solver: condition, strength of the penalty,
/// solution, robust iterations, and the statistics of the result. Keeps references to its
/// arguments.
class FitRun
{
public:
  /// Samples and options must have been checked.
  FitRun(const RadialSamples& samples, const RadialModelFitOptions& options,
         LeastSquaresSolver& solver);

  Status Run(RadialModelFitResult& result);
  /// After Run: false if the solver gave up, so that another one may succeed.
  bool Able() const { return this->IsAble; }

private:
  SampleView View(const std::vector<double>& weights) const;
  bool IsPenalised() const;
  bool IsCancelled() const;
  bool FindStrength();
  CoefficientCovariance Covariance() const;
  double FinishCommon(const std::vector<double>& weights, RadialModelFitResult& result) const;
  Status Finish(RadialModelFitResult& result);
  void FindRmsByDegree(RadialModelFitResult& result) const;
  Status FinishRobust(RadialModelFitResult& result);
  Status FinishHuber(const HuberWeights& huber, const std::vector<double>& weights,
                     RadialModelFitResult& result);
  double RmsRadius() const;

  const RadialSamples& Samples;
  const RadialModelFitOptions& Settings;
  LeastSquaresSolver& Solver;
  std::vector<double> Weights; // normalised
  double Count;                // of samples with positive weight
  double Strength = 0.0;
  bool IsAble = true;
};
} // namespace palpate
