#include "GslHarmonics.h"

#include "SphericalHarmonicBasis.h"

#include <cmath>
#include <gsl/gsl_sf_legendre.h>
#include <utility>

namespace palpate::bench
{
GslHarmonics::GslHarmonics(int degree, std::vector<double> coefficients)
    : Degree(degree), Coefficients(std::move(coefficients)),
      Values(gsl_sf_legendre_array_n(static_cast<std::size_t>(degree))), Slopes(Values.size())
{
}

RadialModel::Sample GslHarmonics::Evaluate(const Vector3& direction)
{
  constexpr double WithoutPhase = 1.0;
  gsl_sf_legendre_deriv_alt_array_e(GSL_SF_LEGENDRE_SPHARM, static_cast<std::size_t>(this->Degree),
                                    direction.z(), WithoutPhase, this->Values.data(),
                                    this->Slopes.data());
  const double sine = std::hypot(direction.x(), direction.y()); // of the polar angle
  const double cosineStep = direction.x() / sine;
  const double sineStep = direction.y() / sine;
  double cosine = std::sqrt(2.0); // sqrt(2) cos(m phi)
  double sineOfOrder = 0.0;
  double radius = 0.0;
  double alongTheta = 0.0;
  double alongPhi = 0.0; // times the sine of the polar angle
  for (int m = 0; m <= this->Degree; ++m)
  {
    double even[2] = {0.0, 0.0}; // sums of the cosine and sine coefficients times P
    double slopes[2] = {0.0, 0.0};
    for (int l = m; l <= this->Degree; ++l)
    {
      const std::size_t at =
          gsl_sf_legendre_array_index(static_cast<std::size_t>(l), static_cast<std::size_t>(m));
      const double c = this->Coefficients[SphericalHarmonicBasis::Index(l, m)];
      const double s = m == 0 ? 0.0 : this->Coefficients[SphericalHarmonicBasis::Index(l, -m)];
      even[0] += c * this->Values[at];
      even[1] += s * this->Values[at];
      slopes[0] += c * this->Slopes[at];
      slopes[1] += s * this->Slopes[at];
    }
    const double scale = m == 0 ? 1.0 / std::sqrt(2.0) : 1.0;
    radius += scale * (even[0] * cosine + even[1] * sineOfOrder);
    alongTheta += scale * (slopes[0] * cosine + slopes[1] * sineOfOrder);
    alongPhi += m * (even[1] * cosine - even[0] * sineOfOrder);
    const double next = cosine * cosineStep - sineOfOrder * sineStep;
    sineOfOrder = cosine * sineStep + sineOfOrder * cosineStep;
    cosine = next;
  }
  const Vector3 theta(direction.z() * cosineStep, direction.z() * sineStep, -sine);
  const Vector3 phi(-sineStep, cosineStep, 0.0);
  return {radius, alongTheta * theta + alongPhi / sine * phi};
}

double GslHarmonics::Radius(const Vector3& direction)
{
  constexpr double WithoutPhase = 1.0;
  gsl_sf_legendre_array_e(GSL_SF_LEGENDRE_SPHARM, static_cast<std::size_t>(this->Degree),
                          direction.z(), WithoutPhase, this->Values.data());
  const double sine = std::hypot(direction.x(), direction.y()); // of the polar angle
  const double cosineStep = direction.x() / sine;
  const double sineStep = direction.y() / sine;
  double cosine = std::sqrt(2.0); // sqrt(2) cos(m phi)
  double sineOfOrder = 0.0;
  double radius = 0.0;
  for (int m = 0; m <= this->Degree; ++m)
  {
    double even[2] = {0.0, 0.0}; // sums of the cosine and sine coefficients times P
    for (int l = m; l <= this->Degree; ++l)
    {
      const double p = this->Values[gsl_sf_legendre_array_index(static_cast<std::size_t>(l),
                                                                static_cast<std::size_t>(m))];
      even[0] += p * this->Coefficients[SphericalHarmonicBasis::Index(l, m)];
      even[1] += m == 0 ? 0.0 : p * this->Coefficients[SphericalHarmonicBasis::Index(l, -m)];
    }
    const double scale = m == 0 ? 1.0 / std::sqrt(2.0) : 1.0;
    radius += scale * (even[0] * cosine + even[1] * sineOfOrder);
    const double next = cosine * cosineStep - sineOfOrder * sineStep;
    sineOfOrder = cosine * sineStep + sineOfOrder * cosineStep;
    cosine = next;
  }
  return radius;
}
} // namespace palpate::bench
