#pragma once

#include "CacheLineVector.h"
#include "EvaluationKernel.h"
#include "InstructionSet.h"
#include "Vector3.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Formulation of the sum over the harmonics.
enum class EvaluationFormulation
{
  Automatic, ///< polynomials up to HighestPolynomialDegree, the recurrence above
  Recurrence ///< the recurrence, which is accurate at every degree
};

/// Evaluates R(u) = sum c_lm Y_lm(u) and its derivatives on the unit sphere, by immutable tables of
/// one set of coefficients. Convention of the coefficients: see SphericalHarmonicBasis. Every query
/// is const, thread-safe and allocation-free; the same query gives the same bits on every thread.
///
/// Lengths are whatever unit the coefficients have (mm in Palpate), angles rad. With |c|^2 =
/// sum c_lm^2 and the scale |c| (L + 1) / sqrt(4 pi) of the addition theorem for degree L, the
/// error of R is at most 1e-14 of the scale up to degree 16, at and near the poles too; that of the
/// gradient the same times sqrt(L (L + 1) / 2), that of the Hessian the same times L (L + 1). By
/// the recurrence it is at most 1e-12 up to degree 1000.
///
/// Directions are unit vectors up to a rounding (of float, say); R is that of the exactly
/// normalised direction. If | |u|^2 - 1 | > 1e-3, or a coordinate is not a number, all results are
/// not-a-number.
class RadialEvaluator
{
public:
  struct Sample
  {
    double Radius;
    Vector3 SurfaceGradient; ///< gradient of R on the unit sphere (per rad), tangent to it
  };
  struct SecondOrderSample
  {
    double Radius;
    Vector3 SurfaceGradient; ///< as in Sample
    /// Covariant Hessian of R on the unit sphere (per rad^2): symmetric, and zero along the
    /// direction. For tangent unit vectors t it is the second derivative of R along the great
    /// circle of t.
    Matrix3 SurfaceHessian;
  };

  /// `coefficients` has (degree + 1)^2 entries, degree >= 0; the processor must support `set`.
  RadialEvaluator(int degree, const std::vector<double>& coefficients,
                  EvaluationFormulation formulation = EvaluationFormulation::Automatic,
                  InstructionSet set = FastestInstructionSet());

  double Radius(const Vector3& direction) const noexcept
  {
    return this->Kernel.Value(this->Table.data(), this->TableDegree, direction.data());
  }
  Sample Evaluate(const Vector3& direction) const noexcept
  {
    static_assert(sizeof(Sample) == 4 * sizeof(double), "the kernels write four numbers");
    Sample sample;
    this->Kernel.Gradient(this->Table.data(), this->TableDegree, direction.data(), &sample.Radius);
    return sample;
  }
  SecondOrderSample EvaluateSecondOrder(const Vector3& direction) const noexcept
  {
    static_assert(sizeof(SecondOrderSample) == 13 * sizeof(double), "the kernels write 13 numbers");
    SecondOrderSample sample;
    this->Kernel.Hessian(this->Table.data(), this->TableDegree, direction.data(), &sample.Radius);
    return sample;
  }

  /// The same for `count` unit vectors. With polynomials several are handled at once; results then
  /// differ from single calls by roundings, but never with `count` or the place in the batch.
  void RadiusBatch(const Vector3* directions, std::size_t count, double* radii) const noexcept
  {
    this->Kernel.Values(this->Table.data(), this->TableDegree, directions->data(),
                        static_cast<long>(count), radii);
  }
  void EvaluateBatch(const Vector3* directions, std::size_t count, Sample* samples) const noexcept
  {
    this->Kernel.Gradients(this->Table.data(), this->TableDegree, directions->data(),
                           static_cast<long>(count), &samples->Radius);
  }
  void EvaluateSecondOrderBatch(const Vector3* directions, std::size_t count,
                                SecondOrderSample* samples) const noexcept
  {
    this->Kernel.Hessians(this->Table.data(), this->TableDegree, directions->data(),
                          static_cast<long>(count), &samples->Radius);
  }

  /// Size of the table that a query reads.
  std::size_t TableBytes() const noexcept { return this->Table.size() * sizeof(double); }

private:
  CacheLineVector<double> Table;
  int TableDegree;
  EvaluationKernel Kernel; // a copy, next to the address of the table
};
} // namespace palpate
