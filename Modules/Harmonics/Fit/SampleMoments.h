#pragma once

#include "CacheLineVector.h"
#include "MomentKernel.h"
#include "MomentTables.h"

#include <memory>

namespace palpate
{
/// View of weighted samples of a radius function. Each pointer has Count entries.
using SampleView = moments::Points;

/// Sums over weighted samples that determine the normal equations of a fit, however many samples
/// there are: the moments of the weights up to twice the degree, and of weight times value up to
/// the degree.
///
/// Sums are over chunks of 32, then over chunks: a moment of n samples has an error of at most
/// (n / 32 + 12 degree + 40) epsilon sum_i w_i, and the same bound holds between any two orders of
/// the samples.
class SampleMoments
{
public:
  SampleMoments(std::shared_ptr<const MomentTables> tables, const moments::Kernel& kernel);

  void Clear() noexcept;
  /// Values and weights must be finite, directions unit vectors. Does not allocate.
  void Add(const SampleView& samples) noexcept;

  /// Pairs (real, imaginary), starting at order 0 and column 0; see moments::MomentStart.
  const double* Weights() const noexcept { return this->GramSums.data(); }
  /// sum_i w_i value_i Y_lm(u_i), (degree + 1)^2 of them.
  void RightSide(double* sums) const noexcept
  {
    this->Tables->ToHarmonics(this->RightSums.data(), sums);
  }

private:
  std::shared_ptr<const MomentTables> Tables;
  const moments::Kernel* Kernel;
  CacheLineVector<double> Scratch;
  CacheLineVector<double> LaneSums;
  CacheLineVector<double> GramSums;
  CacheLineVector<double> RightSums;
};
} // namespace palpate
