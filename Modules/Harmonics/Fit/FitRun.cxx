#include "FitRun.h"

#include "ConditionEstimate.h"
#include "CrossValidation.h"
#include "DecimalText.h"
#include "HuberWeights.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace palpate
{
using Options = RadialModelFitOptions;

namespace
{
Status IllPosed(double condition, const Options& options)
{
  const double limit = options.MaximumCondition;
  return Status::Failure("the directions leave degree " + std::to_string(options.Degree) +
                         " undetermined (condition " +
                         SignificantAgainstLimit(condition, limit, 3) + ", limit " +
                         SignificantAgainstLimit(limit, limit, 3) +
                         "); add a roughness penalty or take a lower degree");
}

// Root mean square difference over the sphere of two radius functions.
double RmsDifference(const CacheLineVector<double>& a, const CacheLineVector<double>& b)
{
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    squares += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(squares / (4.0 * M_PI));
}
} // namespace

FitRun::FitRun(const RadialSamples& samples, const RadialModelFitOptions& options,
               LeastSquaresSolver& solver)
    : Samples(samples), Settings(options), Solver(solver),
      Weights(NormalisedWeights(samples.Weights)),
      Count(static_cast<double>(CountWeighted(samples.Weights)))
{
}

Status FitRun::Run(RadialModelFitResult& result)
{
  result = {};
  this->IsAble = this->Solver.Reduce(this->View(this->Weights));
  if (!this->IsAble)
  {
    return Status::Failure("the normal equations are singular to rounding");
  }
  result.Condition = EstimateCondition(this->Solver.Triangle());
  this->IsAble = result.Condition <= this->Solver.HighestCondition();
  if (!this->IsAble)
  {
    return Status::Failure("the directions are too uneven for the method of moments; use the "
                           "orthogonal one");
  }
  if (!this->IsPenalised() && !(result.Condition <= this->Settings.MaximumCondition))
  {
    return IllPosed(result.Condition, this->Settings);
  }
  if (this->IsCancelled())
  {
    return Status::Failure("cancelled");
  }
  this->IsAble = this->FindStrength() && this->Solver.Solve(this->Strength);
  if (!this->IsAble)
  {
    return Status::Failure("the refinement of the fit does not converge");
  }
  return this->Settings.RobustKind == Options::Robust::None ? this->Finish(result)
                                                            : this->FinishRobust(result);
}

SampleView FitRun::View(const std::vector<double>& weights) const
{
  return {this->Samples.Directions.front().data(), weights.data(), this->Samples.Radii.data(),
          static_cast<long>(weights.size())};
}

bool FitRun::IsPenalised() const
{
  return this->Settings.PenaltyKind != Options::Penalty::None && this->Settings.Degree > 0;
}

bool FitRun::IsCancelled() const
{
  return this->Settings.IsCancelled && this->Settings.IsCancelled();
}

bool FitRun::FindStrength()
{
  if (!this->IsPenalised())
  {
    return true;
  }
  this->Strength = this->Settings.Roughness;
  if (this->Settings.PenaltyKind == Options::Penalty::GeneralisedCrossValidation)
  {
    if (!this->Solver.Project())
    {
      return false;
    }
    this->Strength = CrossValidation(this->Solver, this->Count).Strength();
  }
  return true;
}

CoefficientCovariance FitRun::Covariance() const
{
  return this->IsPenalised()
             ? CoefficientCovariance(this->Solver.Triangle(), this->Solver.System(), 1.0)
             : CoefficientCovariance(this->Solver.Triangle(), 1.0);
}

// Results common to plain and robust fits; returns the weighted sum of squared residuals.
double FitRun::FinishCommon(const std::vector<double>& weights, RadialModelFitResult& result) const
{
  const CacheLineVector<double>& coefficients = this->Solver.Coefficients();
  result.Coefficients.assign(coefficients.begin(),
                             coefficients.begin() + this->Solver.Triangle().Size());
  result.Residuals = this->Solver.Residuals();
  result.Roughness = this->Strength;
  double squares = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    squares += weights[i] * result.Residuals[i] * result.Residuals[i];
    sum += weights[i];
  }
  result.Rms = std::sqrt(squares / sum);
  return squares;
}

Status FitRun::Finish(RadialModelFitResult& result)
{
  const double squares = this->FinishCommon(this->Weights, result);
  result.Covariance = this->Covariance();
  result.DegreesOfFreedom = result.Covariance.DegreesOfFreedom();
  // In rows scaled by the square roots of the weights, the noise of a sample of mean weight is
  // sigma sqrt(4 pi / n).
  const double free = this->Count - result.DegreesOfFreedom;
  const double variance = free > 0.0 ? squares / free : 0.0;
  result.NoiseDeviation = std::sqrt(variance * this->Count / (4.0 * M_PI));
  result.Covariance.SetVariance(variance);
  if (!this->IsPenalised())
  {
    this->FindRmsByDegree(result);
  }
  return Status::Success();
}

// The leading block of the triangle solves the problem of the leading columns.
void FitRun::FindRmsByDegree(RadialModelFitResult& result) const
{
  const CacheLineVector<double>& projection = this->Solver.Projection();
  double squares = this->Solver.Unreachable();
  result.RmsByDegree.resize(static_cast<std::size_t>(this->Settings.Degree) + 1);
  for (int l = this->Settings.Degree; l >= 0; --l)
  {
    result.RmsByDegree[static_cast<std::size_t>(l)] = std::sqrt(squares / (4.0 * M_PI));
    for (int i = l * l; i < (l + 1) * (l + 1); ++i)
    {
      const double value = projection[static_cast<std::size_t>(i)];
      squares += value * value;
    }
  }
}

// Iteratively reweighted least squares, starting from the last solution.
Status FitRun::FinishRobust(RadialModelFitResult& result)
{
  constexpr int MostSteps = 50;
  constexpr int FreeSteps = 10;
  HuberWeights huber(this->Weights);
  std::vector<double> weights = this->Weights;
  const double fitted = this->Covariance().DegreesOfFreedom();
  const double smallest = 1e-9 * this->RmsRadius();
  for (int step = 0; step < MostSteps; ++step)
  {
    if (step < FreeSteps)
    {
      huber.Rescale(this->Solver.Residuals(), fitted, smallest);
    }
    huber.Update(this->Solver.Residuals());
    std::transform(this->Weights.begin(), this->Weights.end(), huber.Factors().begin(),
                   weights.begin(), std::multiplies<>());
    const CacheLineVector<double> before = this->Solver.Coefficients();
    this->IsAble = this->Solver.Reduce(this->View(weights)) &&
                   (step >= FreeSteps || this->FindStrength()) &&
                   this->Solver.Solve(this->Strength);
    if (!this->IsAble || this->IsCancelled())
    {
      return Status::Failure(this->IsAble ? "cancelled" : "the robust fit does not converge");
    }
    if (RmsDifference(before, this->Solver.Coefficients()) <= 1e-4 * huber.Scale())
    {
      break;
    }
  }
  return this->FinishHuber(huber, weights, result);
}

Status FitRun::FinishHuber(const HuberWeights& huber, const std::vector<double>& weights,
                           RadialModelFitResult& result)
{
  this->FinishCommon(weights, result);
  result.RobustFactors = huber.Factors();
  result.DownWeighted = huber.DownWeighted();
  result.NoiseDeviation = huber.Scale();
  // The covariance is that of the full set of samples times a factor.
  this->IsAble = this->Solver.Reduce(this->View(this->Weights)) &&
                 this->Solver.FactoriseSystem(this->Strength);
  if (!this->IsAble)
  {
    return Status::Failure("the normal equations are singular to rounding");
  }
  result.Covariance = this->Covariance();
  result.DegreesOfFreedom = result.Covariance.DegreesOfFreedom();
  result.Covariance.SetVariance(huber.Variance(result.Residuals, result.DegreesOfFreedom) * 4.0 *
                                M_PI / this->Count);
  return Status::Success();
}

double FitRun::RmsRadius() const
{
  double squares = 0.0;
  for (std::size_t i = 0; i < this->Weights.size(); ++i)
  {
    squares += this->Weights[i] * this->Samples.Radii[i] * this->Samples.Radii[i];
  }
  return std::sqrt(squares / (4.0 * M_PI));
}
} // namespace palpate
