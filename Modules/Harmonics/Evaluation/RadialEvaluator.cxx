#include "RadialEvaluator.h"

#include "EvaluationKernelChoice.h"
#include "PolynomialTable.h"
#include "RecurrenceTable.h"
#include "SphericalHarmonicBasis.h"

namespace palpate
{
RadialEvaluator::RadialEvaluator(int degree, const std::vector<double>& coefficients,
                                 EvaluationFormulation formulation, InstructionSet set)
    : TableDegree(degree), Kernel(EvaluationKernelsFor(set).Recurrence)
{
  if (formulation == EvaluationFormulation::Automatic && degree <= HighestPolynomialDegree)
  {
    this->TableDegree = degree + degree % 2;
    this->Kernel = EvaluationKernelsFor(set).Polynomial[this->TableDegree / 2];
    std::vector<double> padded = coefficients;
    padded.resize(SphericalHarmonicBasis::CoefficientCount(this->TableDegree), 0.0);
    this->Table = MakePolynomialTable(this->TableDegree, padded);
  }
  else
  {
    this->Table = MakeRecurrenceTable(degree, {coefficients});
  }
}
} // namespace palpate
