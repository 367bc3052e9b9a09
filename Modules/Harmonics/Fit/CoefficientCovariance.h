#pragma once

#include "PackedTriangle.h"

#include <Eigen/Core>

namespace palpate
{
/// Covariance of fitted coefficients, stored as triangles and evaluated on demand. With
/// A^T A = L L^T from the samples and A^T A + penalty = S S^T, it is variance (S S^T)^-1 L L^T
/// (S S^T)^-1, without a penalty variance (L L^T)^-1. Sample errors are assumed independent, with a
/// variance inverse to the weight. The bias of a penalty is not included.
class CoefficientCovariance
{
public:
  CoefficientCovariance() = default;
  /// Without a penalty.
  CoefficientCovariance(const PackedTriangle& samples, double variance)
      : Samples(samples), Variance(variance)
  {
  }
  CoefficientCovariance(const PackedTriangle& samples, const PackedTriangle& system,
                        double variance)
      : Samples(samples), System(system), Variance(variance)
  {
  }

  void SetVariance(double variance) noexcept { this->Variance = variance; }
  int Size() const noexcept { return this->Samples.Size(); }
  /// Standard deviation (mm) of the fitted radius at a direction with these harmonic values (Size()
  /// of them). Allocates; at most two triangular solves.
  double RadiusDeviation(const double* basisValues) const;
  /// F such that F F^T is the covariance (mm^2).
  Eigen::MatrixXd Factor() const;
  /// Trace of the influence matrix: the number of coefficients that the samples determine.
  double DegreesOfFreedom() const;
  /// Sum of the variances of all coefficients (mm^2): 4 pi times the mean variance of the radius.
  double Trace() const;

private:
  PackedTriangle Samples;
  PackedTriangle System; // empty without a penalty
  double Variance = 0.0;
};
} // namespace palpate
