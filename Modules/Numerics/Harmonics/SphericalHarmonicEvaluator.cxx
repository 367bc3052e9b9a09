#include "SphericalHarmonicEvaluator.h"

#include "EvaluationKernelChoice.h"
#include "PolynomialTable.h"
#include "RecurrenceTable.h"
#include "SphericalHarmonicBasis.h"

namespace palpate
{
template <typename Real>
SphericalHarmonicEvaluator<Real>::SphericalHarmonicEvaluator(
    int degree, const std::vector<double>& coefficients, EvaluationFormulation formulation,
    InstructionSet set)
    : TableDegree(degree), Kernel(KernelsFor<Real>(set).Recurrence)
{
  if (formulation == EvaluationFormulation::Automatic && degree <= HighestPolynomialDegree)
  {
    this->TableDegree = degree + degree % 2;
    this->Kernel = KernelsFor<Real>(set).Polynomial[this->TableDegree / 2];
    std::vector<double> padded = coefficients;
    padded.resize(SphericalHarmonicBasis::CoefficientCount(this->TableDegree), 0.0);
    this->Table = MakePolynomialTable<Real>(this->TableDegree, padded);
  }
  else
  {
    this->Table = MakeRecurrenceTable<Real>(degree, coefficients);
  }
}

template <typename Real>
Real SphericalHarmonicEvaluator<Real>::Radius(const Vector& direction) const noexcept
{
  return this->Kernel.Value(this->Table.data(), this->TableDegree, direction.data());
}

template <typename Real>
auto SphericalHarmonicEvaluator<Real>::Evaluate(const Vector& direction) const noexcept -> Sample
{
  static_assert(sizeof(Sample) == 4 * sizeof(Real), "the kernels write four numbers");
  Sample sample;
  this->Kernel.Gradient(this->Table.data(), this->TableDegree, direction.data(), &sample.Radius);
  return sample;
}

template <typename Real>
auto SphericalHarmonicEvaluator<Real>::EvaluateSecondOrder(const Vector& direction) const noexcept
    -> SecondOrderSample
{
  static_assert(sizeof(SecondOrderSample) == 13 * sizeof(Real), "the kernels write 13 numbers");
  SecondOrderSample sample;
  this->Kernel.Hessian(this->Table.data(), this->TableDegree, direction.data(), &sample.Radius);
  return sample;
}

template <typename Real>
void SphericalHarmonicEvaluator<Real>::RadiusBatch(const Vector* directions, std::size_t count,
                                                   Real* radii) const noexcept
{
  this->Kernel.Values(this->Table.data(), this->TableDegree, directions->data(),
                      static_cast<long>(count), radii);
}

template <typename Real>
void SphericalHarmonicEvaluator<Real>::EvaluateBatch(const Vector* directions, std::size_t count,
                                                     Sample* samples) const noexcept
{
  this->Kernel.Gradients(this->Table.data(), this->TableDegree, directions->data(),
                         static_cast<long>(count), &samples->Radius);
}

template <typename Real>
void SphericalHarmonicEvaluator<Real>::EvaluateSecondOrderBatch(
    const Vector* directions, std::size_t count, SecondOrderSample* samples) const noexcept
{
  this->Kernel.Hessians(this->Table.data(), this->TableDegree, directions->data(),
                        static_cast<long>(count), &samples->Radius);
}

template class SphericalHarmonicEvaluator<double>;
template class SphericalHarmonicEvaluator<float>;
} // namespace palpate
