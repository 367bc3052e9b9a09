#include "SurfaceEvaluator.h"

#include "EvaluationKernelChoice.h"
#include "RecurrenceTable.h"
#include "SphericalHarmonicBasis.h"
#include "SurfacePolynomialTable.h"

namespace palpate
{
SurfaceEvaluator::SurfaceEvaluator(int degree, const Coefficients& coefficients,
                                   EvaluationFormulation formulation, InstructionSet set)
    : TableDegree(degree), Kernel(EvaluationKernelsFor(set).SurfaceRecurrence)
{
  if (formulation == EvaluationFormulation::Automatic && degree <= HighestSurfacePolynomialDegree)
  {
    this->TableDegree = degree + degree % 2;
    this->Kernel = EvaluationKernelsFor(set).SurfacePolynomial;
    Coefficients padded = coefficients;
    for (std::vector<double>& coordinate : padded)
    {
      coordinate.resize(SphericalHarmonicBasis::CoefficientCount(this->TableDegree), 0.0);
    }
    this->Table = MakeSurfacePolynomialTable(this->TableDegree, padded);
  }
  else
  {
    this->Table = MakeRecurrenceTable(degree, {coefficients.begin(), coefficients.end()});
  }
}
} // namespace palpate
