#include "LeastSquaresSolver.h"

#include "SphericalHarmonicBasis.h"

namespace palpate
{
LeastSquaresSolver::LeastSquaresSolver(int degree)
    : MaximumDegree(degree),
      Reduced(static_cast<int>(SphericalHarmonicBasis::CoefficientCount(degree))),
      Solution(Reduced.MakeVector()), Projected(Reduced.MakeVector())
{
}
} // namespace palpate
