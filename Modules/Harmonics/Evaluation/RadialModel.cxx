#include "RadialModel.h"

#include "SphericalHarmonicBasis.h"

#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
std::vector<double> Resized(std::vector<double> coefficients, int degree)
{
  coefficients.resize(SphericalHarmonicBasis::CoefficientCount(degree), 0.0);
  return coefficients;
}
} // namespace

RadialModel::RadialModel(int degree, std::vector<double> coefficients, const Vector3& centerWorld,
                         Formulation formulation)
    : RadialModel(Resized(std::move(coefficients), degree), centerWorld, degree, formulation)
{
}

RadialModel::RadialModel(std::vector<double> coefficients, const Vector3& centerWorld, int degree,
                         Formulation formulation)
    : Evaluator(degree, coefficients, formulation), Center(centerWorld), MaximumDegree(degree),
      Values(std::move(coefficients))
{
}

Vector3 RadialModel::PointWorld(const Vector3& direction) const noexcept
{
  return this->Center + this->Radius(direction) * direction;
}

Vector3 RadialModel::Normal(const Vector3& direction) const noexcept
{
  const Sample sample = this->Evaluate(direction);
  return (sample.Radius * direction - sample.SurfaceGradient).normalized();
}

std::vector<double> RadialModel::PowerSpectrum() const
{
  std::vector<double> power;
  for (int l = 0; l <= this->Degree(); ++l)
  {
    double sum = 0.0;
    for (int m = -l; m <= l; ++m)
    {
      const double c = this->Values[SphericalHarmonicBasis::Index(l, m)];
      sum += c * c;
    }
    power.push_back(sum);
  }
  return power;
}

RadialModel RadialModel::WithDegree(int degree) const
{
  return {degree, this->Values, this->Center};
}
} // namespace palpate
