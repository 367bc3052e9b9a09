#pragma once

#include "CacheLineVector.h"
#include "EvaluationKernel.h"
#include "InstructionSet.h"
#include "RadialEvaluator.h"
#include "Vector3.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// Evaluates X(u) = (x, y, z)(u), each coordinate a sum of spherical harmonics, and its derivatives
/// along the unit sphere, by immutable tables of one set of coefficients. Convention of the
/// coefficients: see SphericalHarmonicBasis. Every query is const, thread-safe and allocation-free;
/// the same query gives the same bits on every thread, alone or in a batch.
///
/// Lengths are whatever unit the coefficients have (mm in Palpate), angles rad. With |c| the length
/// of a coordinate's coefficients and the scale |c| (L + 1) / sqrt(4 pi) of the addition theorem
/// for degree L, the error of that coordinate is at most 1e-14 of the scale up to degree 16 and
/// 1e-12 up to degree 1000, at and near the poles too; that of a first derivative the same times
/// sqrt(L (L + 1) / 2), that of a second derivative the same times L (L + 1). Second derivatives
/// lose 1e-11 near a pole at degree 1000.
///
/// Parameters are unit vectors up to a rounding (of float, say); X is that of the exactly
/// normalised vector. If | |u|^2 - 1 | > 1e-3, or a coordinate is not a number, all results are
/// not-a-number.
class SurfaceEvaluator
{
public:
  /// Derivatives are along `Tangents`, two orthonormal tangents a, b of the unit sphere with
  /// a x b = u. They are a function of u alone, continuous in each half of the sphere (z < 0 and
  /// z >= 0), poles included.
  struct Sample
  {
    Vector3 Point;
    std::array<Vector3, 2> First; ///< X_a, X_b (per rad)
    std::array<Vector3, 2> Tangents;
  };
  struct SecondOrderSample
  {
    Vector3 Point;
    std::array<Vector3, 2> First; ///< as in Sample
    /// X_aa, X_ab, X_bb (per rad^2): the covariant Hessian. s^2 X_aa + 2 s t X_ab + t^2 X_bb is the
    /// second derivative along the great circle of s a + t b, if that has length 1.
    std::array<Vector3, 3> Second;
    std::array<Vector3, 2> Tangents;
  };
  using Coefficients = std::array<std::vector<double>, 3>;

  /// `coefficients` have (degree + 1)^2 entries each, degree >= 0; the processor must support
  /// `set`. Automatic uses polynomials up to HighestSurfacePolynomialDegree.
  SurfaceEvaluator(int degree, const Coefficients& coefficients,
                   EvaluationFormulation formulation = EvaluationFormulation::Automatic,
                   InstructionSet set = FastestInstructionSet());

  Vector3 Point(const Vector3& parameter) const noexcept
  {
    Vector3 point;
    this->Kernel.Point(this->Table.data(), this->TableDegree, parameter.data(), point.data());
    return point;
  }
  Sample Evaluate(const Vector3& parameter) const noexcept
  {
    static_assert(sizeof(Sample) == 15 * sizeof(double), "the kernels write 15 numbers");
    Sample sample;
    this->Kernel.FirstOrder(this->Table.data(), this->TableDegree, parameter.data(),
                            sample.Point.data());
    return sample;
  }
  SecondOrderSample EvaluateSecondOrder(const Vector3& parameter) const noexcept
  {
    static_assert(sizeof(SecondOrderSample) == 24 * sizeof(double), "the kernels write 24 numbers");
    SecondOrderSample sample;
    this->Kernel.SecondOrder(this->Table.data(), this->TableDegree, parameter.data(),
                             sample.Point.data());
    return sample;
  }

  /// The same for `count` unit vectors, with the same bits.
  void PointBatch(const Vector3* parameters, std::size_t count, Vector3* points) const noexcept
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      points[i] = this->Point(parameters[i]);
    }
  }
  void EvaluateBatch(const Vector3* parameters, std::size_t count, Sample* samples) const noexcept
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      samples[i] = this->Evaluate(parameters[i]);
    }
  }
  void EvaluateSecondOrderBatch(const Vector3* parameters, std::size_t count,
                                SecondOrderSample* samples) const noexcept
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      samples[i] = this->EvaluateSecondOrder(parameters[i]);
    }
  }

  /// Size of the table that a query reads.
  std::size_t TableBytes() const noexcept { return this->Table.size() * sizeof(double); }

private:
  CacheLineVector<double> Table;
  int TableDegree;
  SurfaceKernel Kernel; // a copy, next to the address of the table
};
} // namespace palpate
