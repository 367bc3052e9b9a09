#include "SphericalHarmonicModel.h"

#include "PolynomialKernelChoice.h"
#include "SphericalHarmonicBasis.h"
#include "SphericalHarmonicMeasures.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace palpate
{
SphericalHarmonicModel::SphericalHarmonicModel(int degree, std::vector<double> coefficients,
                                               const Vector3& centerWorld, Formulation formulation)
    : Recurrence(degree), Values(std::move(coefficients)), Center(centerWorld)
{
  this->Values.resize(SphericalHarmonicBasis::CoefficientCount(degree), 0.0);
  if (formulation == Formulation::Polynomial ||
      (formulation == Formulation::Automatic && degree <= HighestPolynomialDegree))
  {
    this->Kernel = &polynomial::FastestKernel();
    this->Table = PolynomialTable(degree, this->Values, this->Kernel->Lanes);
  }
  for (int m = 0; m <= degree; ++m)
  {
    for (int l = m; l <= degree; ++l)
    {
      this->Pairs.push_back({this->Values[SphericalHarmonicBasis::Index(l, m)],
                             m == 0 ? 0.0 : this->Values[SphericalHarmonicBasis::Index(l, -m)]});
    }
  }
}

double SphericalHarmonicModel::Radius(const Vector3& direction) const noexcept
{
  return this->Kernel != nullptr
             ? this->Kernel->Radius(this->Table.Data(), this->Degree(), direction.data())
             : this->RadiusByRecurrence(direction);
}

SphericalHarmonicModel::Sample
SphericalHarmonicModel::Evaluate(const Vector3& direction) const noexcept
{
  if (this->Kernel == nullptr)
  {
    return this->EvaluateByRecurrence(direction);
  }
  static_assert(sizeof(Sample) == 4 * sizeof(double), "the kernels write four doubles");
  Sample sample;
  this->Kernel->Evaluate(this->Table.Data(), this->Degree(), direction.data(), &sample.Radius);
  return sample;
}

void SphericalHarmonicModel::EvaluateBatch(const Vector3* directions, std::size_t count,
                                           Sample* samples) const noexcept
{
  if (this->Kernel != nullptr)
  {
    this->Kernel->EvaluateBatch(this->Table.Data(), this->Table.End(), this->Degree(),
                                directions->data(), static_cast<long>(count), &samples->Radius);
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    samples[i] = this->EvaluateByRecurrence(directions[i]);
  }
}

double SphericalHarmonicModel::RadiusByRecurrence(const Vector3& direction) const noexcept
{
  const double z = direction.z();
  const int degree = this->Degree();
  const Pair* pair = this->Pairs.data();
  double radius = 0.0;
  double cosine = 1.0; // Re and Im of (x + iy)^m
  double sine = 0.0;
  for (int m = 0; m <= degree; ++m)
  {
    double previous = 0.0;
    double current = this->Recurrence.Diagonal(m);
    double cosineSum = current * pair->Cosine;
    double sineSum = current * pair->Sine;
    ++pair;
    const SphericalHarmonicRecurrence::Term* term = this->Recurrence.Column(m);
    for (int l = m + 1; l <= degree; ++l, ++term, ++pair)
    {
      const double next = term->A * (z * current - term->B * previous);
      previous = current;
      current = next;
      cosineSum += current * pair->Cosine;
      sineSum += current * pair->Sine;
    }
    radius += cosineSum * cosine + sineSum * sine;
    const double nextCosine = cosine * direction.x() - sine * direction.y();
    sine = cosine * direction.y() + sine * direction.x();
    cosine = nextCosine;
  }
  return radius;
}

SphericalHarmonicModel::Sample
SphericalHarmonicModel::EvaluateByRecurrence(const Vector3& direction) const noexcept
{
  const double z = direction.z();
  const int degree = this->Degree();
  const Pair* pair = this->Pairs.data();
  double radius = 0.0;
  Vector3 gradient = Vector3::Zero(); // of the extension sum Q_lm(z) Re/Im (x + iy)^m
  double cosine = 1.0;                // Re and Im of (x + iy)^m, and of (x + iy)^(m-1)
  double sine = 0.0;
  double lowerCosine = 0.0;
  double lowerSine = 0.0;
  for (int m = 0; m <= degree; ++m)
  {
    double previous = 0.0;
    double current = this->Recurrence.Diagonal(m);
    double previousSlope = 0.0;
    double slope = 0.0; // dQ/dz
    double cosineSum = current * pair->Cosine;
    double sineSum = current * pair->Sine;
    double cosineSlope = 0.0;
    double sineSlope = 0.0;
    ++pair;
    const SphericalHarmonicRecurrence::Term* term = this->Recurrence.Column(m);
    for (int l = m + 1; l <= degree; ++l, ++term, ++pair)
    {
      const double nextSlope = term->A * (current + z * slope - term->B * previousSlope);
      const double next = term->A * (z * current - term->B * previous);
      previous = current;
      current = next;
      previousSlope = slope;
      slope = nextSlope;
      cosineSum += current * pair->Cosine;
      sineSum += current * pair->Sine;
      cosineSlope += slope * pair->Cosine;
      sineSlope += slope * pair->Sine;
    }
    radius += cosineSum * cosine + sineSum * sine;
    gradient.x() += m * (cosineSum * lowerCosine + sineSum * lowerSine);
    gradient.y() += m * (sineSum * lowerCosine - cosineSum * lowerSine);
    gradient.z() += cosineSlope * cosine + sineSlope * sine;
    lowerCosine = cosine;
    lowerSine = sine;
    cosine = lowerCosine * direction.x() - lowerSine * direction.y();
    sine = lowerCosine * direction.y() + lowerSine * direction.x();
  }
  return {radius, gradient - gradient.dot(direction) * direction};
}

SphericalHarmonicModel::SecondOrderSample
SphericalHarmonicModel::EvaluateSecondOrder(const Vector3& direction) const noexcept
{
  using Complex = std::complex<double>;
  const double z = direction.z();
  const Complex w(direction.x(), direction.y());
  const int degree = this->Degree();
  const Pair* pair = this->Pairs.data();
  double radius = 0.0;
  // Of the extension sum Re (C_m - i S_m)(z) w^m, whose terms have the derivatives of w^m in x, y.
  Vector3 gradient = Vector3::Zero();
  Matrix3 hessian = Matrix3::Zero();
  Complex powers[3] = {1.0, 0.0, 0.0}; // w^m, w^(m-1), w^(m-2)
  for (int m = 0; m <= degree; ++m)
  {
    // Value, first and second derivative in z of Q, and the sums of C - i S.
    double previous[3] = {0.0, 0.0, 0.0};
    double current[3] = {this->Recurrence.Diagonal(m), 0.0, 0.0};
    Complex sums[3] = {};
    const SphericalHarmonicRecurrence::Term* term = this->Recurrence.Column(m);
    for (int l = m;; ++l, ++term)
    {
      const Complex coefficient(pair->Cosine, -pair->Sine);
      ++pair;
      for (int k = 0; k < 3; ++k)
      {
        sums[k] += current[k] * coefficient;
      }
      if (l == degree)
      {
        break;
      }
      const double next[3] = {term->A * (z * current[0] - term->B * previous[0]),
                              term->A * (current[0] + z * current[1] - term->B * previous[1]),
                              term->A *
                                  (2.0 * current[1] + z * current[2] - term->B * previous[2])};
      std::copy_n(current, 3, previous);
      std::copy_n(next, 3, current);
    }
    const Complex first = static_cast<double>(m) * powers[1];
    const Complex second = static_cast<double>(m) * (m - 1.0) * powers[2];
    const Complex alongX = sums[0] * first;
    const Complex alongXZ = sums[1] * first;
    const Complex alongXX = sums[0] * second;
    radius += (sums[0] * powers[0]).real();
    gradient += Vector3(alongX.real(), -alongX.imag(), (sums[1] * powers[0]).real());
    hessian(0, 0) += alongXX.real();
    hessian(0, 1) -= alongXX.imag();
    hessian(0, 2) += alongXZ.real();
    hessian(1, 2) -= alongXZ.imag();
    hessian(2, 2) += (sums[2] * powers[0]).real();
    powers[2] = powers[1];
    powers[1] = powers[0];
    powers[0] *= w;
  }
  hessian(1, 1) = -hessian(0, 0); // Re and Im of w^m are harmonic in the plane
  const Matrix3 symmetric = hessian.selfadjointView<Eigen::Upper>();
  const Matrix3 tangent = Matrix3::Identity() - direction * direction.transpose();
  const double radial = gradient.dot(direction);
  return {radius, gradient - radial * direction, tangent * symmetric * tangent - radial * tangent};
}

Vector3 SphericalHarmonicModel::PointWorld(const Vector3& direction) const noexcept
{
  return this->Center + this->Radius(direction) * direction;
}

Vector3 SphericalHarmonicModel::Normal(const Vector3& direction) const noexcept
{
  const Sample sample = this->Evaluate(direction);
  return (sample.Radius * direction - sample.SurfaceGradient).normalized();
}

double SphericalHarmonicModel::Volume() const
{
  return VolumeOf(*this);
}

double SphericalHarmonicModel::Area() const
{
  return AreaOf(*this).Value;
}

std::vector<double> SphericalHarmonicModel::PowerSpectrum() const
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

SphericalHarmonicModel SphericalHarmonicModel::WithDegree(int degree) const
{
  std::vector<double> values(SphericalHarmonicBasis::CoefficientCount(degree), 0.0);
  std::copy_n(this->Values.begin(), std::min(values.size(), this->Values.size()), values.begin());
  return {degree, std::move(values), this->Center};
}
} // namespace palpate
