#include "SphericalHarmonicEvaluator.h"

#include "EvaluationKernelsPortable.h"
#include "PolynomialTable.h"
#include "RecurrenceTable.h"
#include "SphericalHarmonicBasis.h"
#if defined(__x86_64__)
#include "EvaluationKernelsAvx2.h"
#endif

namespace palpate
{
namespace
{
const EvaluationKernels& KernelsFor(InstructionSet set)
{
#if defined(__x86_64__)
  if (set == InstructionSet::Avx2)
  {
    return evaluation::Avx2;
  }
#endif
  return evaluation::Portable;
}
} // namespace

SphericalHarmonicEvaluator::SphericalHarmonicEvaluator(int degree,
                                                       const std::vector<double>& coefficients,
                                                       EvaluationFormulation formulation,
                                                       InstructionSet set)
    : TableDegree(degree), Kernel(KernelsFor(set).Recurrence)
{
  if (formulation == EvaluationFormulation::Automatic && degree <= HighestPolynomialDegree)
  {
    this->TableDegree = degree + degree % 2;
    this->Kernel = KernelsFor(set).Polynomial[this->TableDegree / 2];
    std::vector<double> padded = coefficients;
    padded.resize(SphericalHarmonicBasis::CoefficientCount(this->TableDegree), 0.0);
    this->Table = MakePolynomialTable(this->TableDegree, padded);
  }
  else
  {
    this->Table = MakeRecurrenceTable(degree, coefficients);
  }
}
} // namespace palpate
