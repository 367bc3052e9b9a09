#include "SphericalHarmonicProjection.h"

#include "SphereQuadrature.h"
#include "SphericalHarmonicBasis.h"

namespace palpate
{
std::vector<double> ProjectOnHarmonics(int degree, int quadratureDegree,
                                       const std::function<double(const Vector3&)>& function)
{
  const SphericalHarmonicBasis basis(degree);
  const SphereQuadrature sphere(quadratureDegree);
  std::vector<double> values(basis.Size());
  std::vector<double> coefficients(basis.Size(), 0.0);
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    basis.Evaluate(sphere.Directions[i], values.data());
    const double weighted = sphere.Weights[i] * function(sphere.Directions[i]);
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      coefficients[k] += weighted * values[k];
    }
  }
  return coefficients;
}
} // namespace palpate
