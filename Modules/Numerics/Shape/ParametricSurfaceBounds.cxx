#include "ParametricSurfaceBounds.h"

#include "IcosahedronDirections.h"
#include "SphericalHarmonicBasis.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Bounds of the evaluation error at every degree, in units of what coefficients of the same length
// can reach; second derivatives are less exact near a pole.
constexpr double FirstTolerance = 1e-12;
constexpr double SecondTolerance = 1e-11;
constexpr double RoundUp = 1.0 + 1e-9;

// The largest length that the coefficients of degree l have along any direction of space.
double Amplitude(const ParametricSphericalSurface& surface, int l)
{
  Matrix3 squares = Matrix3::Zero();
  for (int m = -l; m <= l; ++m)
  {
    const std::size_t k = SphericalHarmonicBasis::Index(l, m);
    const Vector3 c(surface.Coefficients(0)[k], surface.Coefficients(1)[k],
                    surface.Coefficients(2)[k]);
    squares += c * c.transpose();
  }
  // The eigenvalues are those of the matrix up to rounding of its trace.
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(squares, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2]) + 1e-14 * squares.trace());
}

// Of |P + Q cos + R sin| over the circle: its square has two harmonics.
double LargestOnCircle(const Vector3& p, const Vector3& q, const Vector3& r)
{
  const double constant = p.squaredNorm() + 0.5 * (q.squaredNorm() + r.squaredNorm());
  const double first = 2.0 * std::hypot(p.dot(q), p.dot(r));
  const double second = std::hypot(0.5 * (q.squaredNorm() - r.squaredNorm()), q.dot(r));
  return std::sqrt(constant + first + second);
}

// Around a value of a trigonometric polynomial of this degree and largest size; NaN as `largest`.
double Around(double value, double largest, double degree, double angle)
{
  if (!(value < largest) || !(angle >= 0.0))
  {
    return largest;
  }
  return largest * std::cos(std::max(0.0, std::acos(value / largest) - degree * angle));
}
} // namespace

ParametricSurfaceBounds::ParametricSurfaceBounds(const ParametricSphericalSurface& surface)
    : Degree(surface.Degree())
{
  double third = 0.0;
  double squares = 0.0;
  for (int l = 0; l <= this->Degree; ++l)
  {
    // See SphericalHarmonicSpectrum.
    const double k = l * (l + 1.0);
    const double amplitude = Amplitude(surface, l);
    third += l * amplitude * std::sqrt((2 * l + 1) / (4.0 * M_PI) * k * (3.0 * k - 2.0) / 8.0);
    squares += amplitude * amplitude;
  }
  const double scale = std::sqrt(squares / (4.0 * M_PI)) * (this->Degree + 1);
  const double eigenvalue = this->Degree * (this->Degree + 1.0);
  this->FirstError = FirstTolerance * scale * std::sqrt(0.5 * eigenvalue);
  this->SecondError = SecondTolerance * scale * eigenvalue;

  const IcosahedronDirections sphere(std::max(1, 2 * this->Degree));
  for (const Vector3& parameter : sphere.Directions())
  {
    const auto sample = surface.EvaluateSecondOrder(parameter);
    // Comparisons such that NaN propagates: it must not look like a bound.
    const double first = LargestFirstAt(sample.First);
    const double second = LargestSecondAt(sample);
    this->LargestFirst = first <= this->LargestFirst ? this->LargestFirst : first;
    this->LargestSecond = second <= this->LargestSecond ? this->LargestSecond : second;
  }
  const double fall = std::cos(this->Degree * sphere.LargestGap());
  this->LargestFirst = RoundUp * (this->LargestFirst + this->FirstError) / fall;
  this->LargestSecond = RoundUp * (this->LargestSecond + this->SecondError) / fall;
  this->LargestThird = RoundUp * std::min(third, this->Degree * this->LargestSecond);
}

double ParametricSurfaceBounds::LargestSecondAt(
    const ParametricSphericalSurface::SecondOrderSample& sample) noexcept
{
  const auto& [aa, ab, bb] = sample.Second;
  // With t = cos a + sin b: X_tt = (aa + bb) / 2 + (aa - bb) / 2 cos 2 + ab sin 2.
  return LargestOnCircle(0.5 * (aa + bb), 0.5 * (aa - bb), ab);
}

double ParametricSurfaceBounds::LargestFirstAt(const std::array<Vector3, 2>& first) noexcept
{
  return LargestOnCircle(Vector3::Zero(), first[0], first[1]);
}

double
ParametricSurfaceBounds::FirstAround(const ParametricSphericalSurface::SecondOrderSample& sample,
                                     double angle) const noexcept
{
  const double here = RoundUp * (LargestFirstAt(sample.First) + this->FirstError);
  // X_t of a tangent that is carried along changes by X_st, with s along the arc.
  const double change = RoundUp * this->SecondAround(sample, angle) * angle;
  return std::min(Around(here, this->LargestFirst, this->Degree, angle),
                  here + change >= 0.0 ? here + change : this->LargestFirst);
}

double
ParametricSurfaceBounds::SecondAround(const ParametricSphericalSurface::SecondOrderSample& sample,
                                      double angle) const noexcept
{
  const double here = RoundUp * (LargestSecondAt(sample) + this->SecondError);
  const double taylor = here + this->LargestThird * angle;
  return std::min(Around(here, this->LargestSecond, this->Degree, angle),
                  taylor >= here ? taylor : this->LargestSecond);
}

double ParametricSurfaceBounds::SecondOver(const ParametricSphericalSurface& surface,
                                           const SphericalTriangle& triangle,
                                           int refinement) const noexcept
{
  if (refinement <= 0)
  {
    const SphericalCap cap = triangle.Cap();
    return this->SecondAround(surface.EvaluateSecondOrder(cap.Center), cap.Radius);
  }
  double largest = 0.0;
  for (const SphericalTriangle& part : triangle.Split())
  {
    const double second = this->SecondOver(surface, part, refinement - 1);
    largest = second <= largest ? largest : second;
  }
  return largest;
}

double ParametricSurfaceBounds::DeviationFromTriangle(const SphericalTriangle& triangle,
                                                      double second) noexcept
{
  std::array<double, 3> edges{}; // rad, opposite each corner
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector3& a = triangle.Corners[(i + 1) % 3];
    const Vector3& b = triangle.Corners[(i + 2) % 3];
    edges[i] = std::atan2(a.cross(b).norm(), a.dot(b));
  }
  // Any parameter is on an arc from a corner to the opposite edge, at the share w of its length. On
  // the edge X leaves the chord by at most edge^2 / 8, on the arc by w (1 - w) arc^2 / 2, and w of
  // the former comes on top.
  double least = INFINITY;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double edge = edges[i] * edges[i] / 8.0;
    const double longest = std::max(edges[(i + 1) % 3], edges[(i + 2) % 3]);
    const double arc = longest * longest / 2.0;
    const double w = std::min(1.0, 0.5 * (edge + arc) / arc);
    least = std::min(least, w * (edge + (1.0 - w) * arc));
  }
  return RoundUp * second * least;
}
} // namespace palpate
