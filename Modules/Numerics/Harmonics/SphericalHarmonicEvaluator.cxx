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

template class SphericalHarmonicEvaluator<double>;
template class SphericalHarmonicEvaluator<float>;
} // namespace palpate
