#include "MomentSolver.h"

#include "MomentKernelChoice.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Corrections below this fraction of the coefficients are omitted from the residuals: rounding of
// the radii has the same effect.
constexpr double Negligible = 1e-14;
// If a correction that no longer shrinks is larger than this, refinement has failed.
constexpr double Converged = 1e-9;
constexpr int MostSteps = 8;

double NormOf(const CacheLineVector<double>& v)
{
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size())).norm();
}
} // namespace

MomentSolver::MomentSolver(int degree)
    : MomentSolver(degree, moments::KernelFor(FastestInstructionSet()))
{
}

MomentSolver::MomentSolver(int degree, const moments::Kernel& kernel)
    : LeastSquaresSolver(degree),
      Tables(std::make_shared<const MomentTables>(degree, kernel.Lanes)), Moments(Tables, kernel),
      Residual(Tables, kernel), Assembly(*Tables, kernel), Gram(Reduced),
      Right(Reduced.MakeVector()), Correction(Reduced.MakeVector())
{
}

bool MomentSolver::Reduce(const SampleView& samples)
{
  this->Samples = samples;
  this->IsPenalised = false;
  this->Moments.Clear();
  this->Moments.Add(samples);
  this->Gram.Clear();
  this->Assembly.Assemble(*this->Tables, this->Moments.Weights(), 1.0, this->Gram);
  this->Moments.RightSide(this->Right.data());
  this->Reduced = this->Gram;
  return this->Reduced.Factorise();
}

bool MomentSolver::FactoriseSystem(double strength)
{
  this->IsPenalised = strength > 0.0;
  if (!this->IsPenalised)
  {
    return true;
  }
  this->Penalised = this->Gram;
  for (int l = 1; l <= this->MaximumDegree; ++l)
  {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i)
    {
      this->Penalised.At(i, i) += strength * Roughness(l);
    }
  }
  return this->Penalised.Factorise();
}

bool MomentSolver::Solve(double strength)
{
  if (!this->FactoriseSystem(strength))
  {
    return false;
  }
  this->Solution = this->Right;
  this->System().Solve(this->Solution.data());
  this->Left.resize(static_cast<std::size_t>(this->Samples.Count));
  if (!this->Refine(strength))
  {
    return false;
  }
  if (!this->IsPenalised)
  {
    this->ProjectSolution();
  }
  return true;
}

void MomentSolver::ProjectSolution()
{
  this->Reduced.MultiplyUpper(this->Solution.data(), this->Projected.data());
  this->UnreachableSquares = 0.0;
  for (std::size_t i = 0; i < this->Left.size(); ++i)
  {
    this->UnreachableSquares += this->Samples.Weights[i] * this->Left[i] * this->Left[i];
  }
}

bool MomentSolver::Refine(double strength)
{
  double last = NormOf(this->Solution);
  for (int step = 0; step < MostSteps; ++step)
  {
    const double correction = this->Correct(strength);
    const double size = NormOf(this->Solution);
    if (!std::isfinite(correction))
    {
      return false;
    }
    if (correction <= Negligible * size)
    {
      return true;
    }
    if (correction > 0.25 * last)
    {
      return correction <= Converged * size;
    }
    last = correction;
  }
  return last <= Converged * NormOf(this->Solution);
}

// One refinement step; returns the size of the correction. The residuals are those before it.
double MomentSolver::Correct(double strength)
{
  // An earlier fit that overflowed may have left non-finite values in the padding.
  std::fill(this->Correction.begin(), this->Correction.end(), 0.0);
  this->Residual.Find(this->Samples, this->Solution.data(), this->Left.data(),
                      this->Correction.data());
  for (int l = 1; this->IsPenalised && l <= this->MaximumDegree; ++l)
  {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      this->Correction[at] -= strength * Roughness(l) * this->Solution[at];
    }
  }
  this->System().Solve(this->Correction.data());
  for (std::size_t i = 0; i < this->Solution.size(); ++i)
  {
    this->Solution[i] += this->Correction[i];
  }
  return NormOf(this->Correction);
}
} // namespace palpate
