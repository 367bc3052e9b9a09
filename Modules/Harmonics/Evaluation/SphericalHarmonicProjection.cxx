#include "SphericalHarmonicProjection.h"

#include "SphereQuadrature.h"
#include "SphericalHarmonicBasis.h"

namespace palpate
{
namespace
{
// Calls add(u, weight, harmonics at u) for every node of the quadrature.
template <typename Add>
void ForEachNode(int degree, int quadratureDegree, const Add& add)
{
  const SphericalHarmonicBasis basis(degree);
  const SphereQuadrature sphere(quadratureDegree);
  std::vector<double> values(basis.Size());
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    basis.Evaluate(sphere.Directions[i], values.data());
    add(sphere.Directions[i], sphere.Weights[i], values);
  }
}

void AddTimes(double factor, const std::vector<double>& values, std::vector<double>& sum)
{
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    sum[k] += factor * values[k];
  }
}
} // namespace

std::vector<double> ProjectOnHarmonics(int degree, int quadratureDegree,
                                       const std::function<double(const Vector3&)>& function)
{
  std::vector<double> coefficients(SphericalHarmonicBasis::CoefficientCount(degree), 0.0);
  ForEachNode(degree, quadratureDegree,
              [&](const Vector3& u, double weight, const std::vector<double>& harmonics)
              { AddTimes(weight * function(u), harmonics, coefficients); });
  return coefficients;
}

std::array<std::vector<double>, 3>
ProjectPointsOnHarmonics(int degree, int quadratureDegree,
                         const std::function<Vector3(const Vector3&)>& function)
{
  const std::vector<double> zeros(SphericalHarmonicBasis::CoefficientCount(degree), 0.0);
  std::array<std::vector<double>, 3> coefficients{zeros, zeros, zeros};
  ForEachNode(degree, quadratureDegree,
              [&](const Vector3& u, double weight, const std::vector<double>& harmonics)
              {
                const Vector3 point = weight * function(u);
                AddTimes(point.x(), harmonics, coefficients[0]);
                AddTimes(point.y(), harmonics, coefficients[1]);
                AddTimes(point.z(), harmonics, coefficients[2]);
              });
  return coefficients;
}
} // namespace palpate
