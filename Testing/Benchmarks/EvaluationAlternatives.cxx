#include "EvaluationAlternatives.h"

#include "GaussLegendre.h"
#include "SphericalHarmonicBasis.h"

#include <cmath>
#include <complex>
#include <gsl/gsl_sf_legendre.h>
#include <libsharp/sharp.h>
#include <libsharp/sharp_almhelpers.h>
#include <libsharp/sharp_geomhelpers.h>

namespace palpate::bench
{
namespace
{
using Sample = SphericalHarmonicModel::Sample;

double Coefficient(const std::vector<double>& coefficients, int l, int m)
{
  return coefficients[SphericalHarmonicBasis::Index(l, m)];
}

// theta and phi of a direction off the poles, and the unit vectors along them.
struct Angles
{
  explicit Angles(const Vector3& u)
      : SinTheta(std::hypot(u.x(), u.y())), CosPhi(u.x() / SinTheta), SinPhi(u.y() / SinTheta),
        AlongTheta(u.z() * CosPhi, u.z() * SinPhi, -SinTheta), AlongPhi(-SinPhi, CosPhi, 0.0)
  {
  }
  double SinTheta;
  double CosPhi;
  double SinPhi;
  Vector3 AlongTheta;
  Vector3 AlongPhi;
};

// cos and sin of m phi, the next m by rotation.
struct Turn
{
  void Advance(const Angles& angles)
  {
    const double next = this->Cosine * angles.CosPhi - this->Sine * angles.SinPhi;
    this->Sine = this->Cosine * angles.SinPhi + this->Sine * angles.CosPhi;
    this->Cosine = next;
  }
  double Cosine = 1.0;
  double Sine = 0.0;
};
} // namespace

GslEvaluator::GslEvaluator(const SphericalHarmonicModel& model)
    : Degree(model.Degree()), Coefficients(model.Coefficients()),
      Legendre(gsl_sf_legendre_array_n(static_cast<std::size_t>(model.Degree()))),
      Derivatives(Legendre.size())
{
  // GSL's functions are orthonormal over the sphere in the complex form.
  for (int l = 1; l <= this->Degree; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      this->Coefficients[SphericalHarmonicBasis::Index(l, m)] *= m == 0 ? 1.0 : std::sqrt(2.0);
    }
  }
}

double GslEvaluator::Radius(const Vector3& direction)
{
  const auto degree = static_cast<std::size_t>(this->Degree);
  gsl_sf_legendre_array(GSL_SF_LEGENDRE_SPHARM, degree, direction.z(), this->Legendre.data());
  const Angles angles(direction);
  Turn turn;
  double radius = 0.0;
  for (int m = 0; m <= this->Degree; ++m, turn.Advance(angles))
  {
    for (int l = m; l <= this->Degree; ++l)
    {
      const double term = Coefficient(this->Coefficients, l, m) * turn.Cosine +
                          (m == 0 ? 0.0 : Coefficient(this->Coefficients, l, -m) * turn.Sine);
      radius += term * this->Legendre[static_cast<std::size_t>(l * (l + 1) / 2 + m)];
    }
  }
  return radius;
}

Sample GslEvaluator::Evaluate(const Vector3& direction)
{
  const auto degree = static_cast<std::size_t>(this->Degree);
  gsl_sf_legendre_deriv_alt_array(GSL_SF_LEGENDRE_SPHARM, degree, direction.z(),
                                  this->Legendre.data(), this->Derivatives.data());
  const Angles angles(direction);
  Turn turn;
  double radius = 0.0;
  double alongTheta = 0.0;
  double alongPhi = 0.0;
  for (int m = 0; m <= this->Degree; ++m, turn.Advance(angles))
  {
    for (int l = m; l <= this->Degree; ++l)
    {
      const double cosine = Coefficient(this->Coefficients, l, m);
      const double sine = m == 0 ? 0.0 : Coefficient(this->Coefficients, l, -m);
      const double term = cosine * turn.Cosine + sine * turn.Sine;
      const auto k = static_cast<std::size_t>(l * (l + 1) / 2 + m);
      radius += term * this->Legendre[k];
      alongTheta += term * this->Derivatives[k];
      alongPhi += m * (sine * turn.Cosine - cosine * turn.Sine) * this->Legendre[k];
    }
  }
  return {radius, alongTheta * angles.AlongTheta + alongPhi / angles.SinTheta * angles.AlongPhi};
}

double StandardEvaluator::Radius(const Vector3& direction) const
{
  const Angles angles(direction);
  const double theta = std::atan2(angles.SinTheta, direction.z());
  const std::vector<double>& c = this->Model.Coefficients();
  double radius = 0.0;
  for (int l = 0; l <= this->Model.Degree(); ++l)
  {
    Turn turn;
    for (int m = 0; m <= l; ++m, turn.Advance(angles))
    {
      // With the Condon-Shortley phase, which we do without.
      const double y = (m % 2 == 0 ? 1.0 : -1.0) * (m == 0 ? 1.0 : std::sqrt(2.0)) *
                       std::sph_legendre(static_cast<unsigned>(l), static_cast<unsigned>(m), theta);
      radius += y * (Coefficient(c, l, m) * turn.Cosine +
                     (m == 0 ? 0.0 : Coefficient(c, l, -m) * turn.Sine));
    }
  }
  return radius;
}

Sample StandardEvaluator::Evaluate(const Vector3& direction) const
{
  const Angles angles(direction);
  const double theta = std::atan2(angles.SinTheta, direction.z());
  const std::vector<double>& c = this->Model.Coefficients();
  double radius = 0.0;
  double alongTheta = 0.0;
  double alongPhi = 0.0;
  for (int l = 0; l <= this->Model.Degree(); ++l)
  {
    Turn turn;
    double previous = 0.0; // of order m - 1
    double current = std::sph_legendre(static_cast<unsigned>(l), 0, theta);
    for (int m = 0; m <= l; ++m, turn.Advance(angles))
    {
      const double next =
          m == l ? 0.0
                 : std::sph_legendre(static_cast<unsigned>(l), static_cast<unsigned>(m) + 1, theta);
      // d/dtheta of a normalised function with the phase, from its neighbours in order; that of
      // order -1 is minus that of order 1.
      const double up = std::sqrt((l - m) * (l + m + 1.0)) * next;
      const double slope = m == 0 ? up : 0.5 * (up - std::sqrt((l + m) * (l - m + 1.0)) * previous);
      const double factor = (m % 2 == 0 ? 1.0 : -1.0) * (m == 0 ? 1.0 : std::sqrt(2.0));
      const double cosine = factor * Coefficient(c, l, m);
      const double sine = m == 0 ? 0.0 : factor * Coefficient(c, l, -m);
      const double term = cosine * turn.Cosine + sine * turn.Sine;
      radius += term * current;
      alongTheta += term * slope;
      alongPhi += m * (sine * turn.Cosine - cosine * turn.Sine) * current;
      previous = current;
      current = next;
    }
  }
  return {radius, alongTheta * angles.AlongTheta + alongPhi / angles.SinTheta * angles.AlongPhi};
}

struct SharpGrid::Sharp
{
  std::vector<std::complex<double>> Coefficients;
  sharp_alm_info* Terms = nullptr;
  sharp_geom_info* Grid = nullptr;
};

SharpGrid::SharpGrid(const SphericalHarmonicModel& model, int latitudes, int longitudes)
    : Library(std::make_unique<Sharp>())
{
  sharp_make_triangular_alm_info(model.Degree(), model.Degree(), 1, &this->Library->Terms);
  sharp_make_gauss_geom_info(latitudes, longitudes, 0.0, 1, longitudes, &this->Library->Grid);
  for (int m = 0; m <= model.Degree(); ++m)
  {
    for (int l = m; l <= model.Degree(); ++l)
    {
      // Complex, with the Condon-Shortley phase.
      const std::complex<double> pair(Coefficient(model.Coefficients(), l, m),
                                      m == 0 ? 0.0 : -Coefficient(model.Coefficients(), l, -m));
      this->Library->Coefficients.push_back(
          pair * (m == 0 ? 1.0 : (m % 2 == 0 ? 1.0 : -1.0) * std::sqrt(0.5)));
    }
  }
  const GaussLegendre rings(latitudes);
  for (int i = 0; i < latitudes; ++i)
  {
    const double z = -rings.Nodes[static_cast<std::size_t>(i)]; // from the north on
    const double s = std::sqrt((1.0 - z) * (1.0 + z));
    for (int j = 0; j < longitudes; ++j)
    {
      const double phi = 2.0 * M_PI * j / longitudes;
      this->Points.emplace_back(s * std::cos(phi), s * std::sin(phi), z);
    }
  }
  this->Values.resize(this->Points.size());
  this->AlongTheta.resize(this->Points.size());
  this->AlongPhi.resize(this->Points.size());
}

SharpGrid::~SharpGrid()
{
  sharp_destroy_alm_info(this->Library->Terms);
  sharp_destroy_geom_info(this->Library->Grid);
}

void SharpGrid::Synthesise()
{
  void* alm = this->Library->Coefficients.data();
  void* map = this->Values.data();
  sharp_execute(SHARP_ALM2MAP, 0, &alm, &map, this->Library->Grid, this->Library->Terms, SHARP_DP,
                nullptr, nullptr);
}

void SharpGrid::SynthesiseWithSlopes()
{
  this->Synthesise();
  void* alm = this->Library->Coefficients.data();
  void* maps[] = {this->AlongTheta.data(), this->AlongPhi.data()};
  sharp_execute(SHARP_ALM2MAP_DERIV1, 1, &alm, maps, this->Library->Grid, this->Library->Terms,
                SHARP_DP, nullptr, nullptr);
}

Sample SharpGrid::SampleAt(std::size_t point) const
{
  const Angles angles(this->Points[point]);
  return {this->Values[point],
          this->AlongTheta[point] * angles.AlongTheta + this->AlongPhi[point] * angles.AlongPhi};
}
} // namespace palpate::bench
