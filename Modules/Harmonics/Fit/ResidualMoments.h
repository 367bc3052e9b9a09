#pragma once

#include "CacheLineVector.h"
#include "MomentKernel.h"
#include "MomentTables.h"
#include "SampleMoments.h"

#include <memory>

namespace palpate
{
/// Residuals of samples against a model, and their weighted sums with the harmonics, in one pass:
/// one step of iterative refinement. Some 500 products per sample at degree 12. Rounding errors of
/// the residuals are those of evaluating the model: some epsilon of its radius. Holds scratch
/// memory, so each thread needs its own; calls do not allocate.
class ResidualMoments
{
public:
  ResidualMoments(std::shared_ptr<const MomentTables> tables, const moments::Kernel& kernel);

  /// `coefficients`: (degree + 1)^2; `residuals`: one per sample;
  /// `sums` receives sum_i w_i residual_i Y_lm(u_i), (degree + 1)^2 of them.
  void Find(const SampleView& samples, const double* coefficients, double* residuals,
            double* sums) noexcept;

private:
  std::shared_ptr<const MomentTables> Tables;
  const moments::Kernel* Kernel;
  CacheLineVector<double> Scratch;
  CacheLineVector<double> LaneSums;
  CacheLineVector<double> Pairs;
};
} // namespace palpate
