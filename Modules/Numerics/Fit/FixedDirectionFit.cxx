#include "FixedDirectionFit.h"

#include "ConditionEstimate.h"
#include "MomentSolver.h"
#include "RadialSamples.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
Status FixedDirectionFit::Prepare(std::vector<Vector3> directions,
                                  const std::vector<double>& weights, int degree, double strength)
{
  RadialSamples samples{std::move(directions), {}, weights};
  samples.Radii.assign(samples.Directions.size(), 0.0);
  Status status = CheckSamples(samples, degree);
  if (!status.IsOk())
  {
    return status;
  }
  if (!(strength >= 0.0) || !std::isfinite(strength))
  {
    return Status::Failure("the strength of the penalty must not be negative");
  }
  const std::vector<double> normalised = NormalisedWeights(weights);
  MomentSolver solver(degree);
  // Only with a penalty may the samples alone be singular.
  const bool determined =
      solver.Reduce({samples.Directions.front().data(), normalised.data(), samples.Radii.data(),
                     static_cast<long>(normalised.size())});
  if ((!determined && strength == 0.0) || !solver.FactoriseSystem(strength) ||
      (strength == 0.0 && !(EstimateCondition(solver.System()) <= HighestCondition)))
  {
    return Status::Failure("the directions leave the degree undetermined; add a roughness penalty "
                           "or take a lower degree");
  }
  this->System = solver.System();
  this->Tables = solver.SharedTables();
  this->Weights = normalised;
  this->Directions = std::move(samples.Directions);
  return Status::Success();
}

FixedDirectionFit::Scratch FixedDirectionFit::MakeScratch() const
{
  return {ResidualMoments(this->Tables), this->System.MakeVector()};
}

bool FixedDirectionFit::Refit(const double* radii, Scratch& scratch,
                              double* coefficients) const noexcept
{
  // A radius that was not finite may have left its mark in the padding.
  std::fill(scratch.Coefficients.begin(), scratch.Coefficients.end(), 0.0);
  scratch.Sums.Find({this->Directions.front().data(), this->Weights.data(), radii,
                     static_cast<long>(this->Weights.size())},
                    nullptr, nullptr, scratch.Coefficients.data());
  this->System.Solve(scratch.Coefficients.data());
  const auto end = scratch.Coefficients.begin() + this->System.Size();
  if (!std::all_of(scratch.Coefficients.begin(), end,
                   [](double value) { return std::isfinite(value); }))
  {
    return false;
  }
  std::copy(scratch.Coefficients.begin(), end, coefficients);
  return true;
}
} // namespace palpate
