#include "PointDerivativeBounds.h"

#include "CenteredSurfaceSample.h"
#include "IcosahedronDirections.h"
#include "SphericalHarmonicProjection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
// The third derivatives along great circles. On the sphere the three components of a coordinate's
// surface gradient g are harmonic sums of one degree more. With t the tangent of a great circle and
// t' = -u, the derivatives of the coordinate are g.t, g'.t and g''.t + g.t.
class ThirdDerivatives
{
public:
  explicit ThirdDerivatives(const CenteredSurface& shape)
  {
    const int degree = shape.Degree() + 1;
    for (Eigen::Index component = 0; component < 9; ++component)
    {
      const std::vector<double> coefficients = ProjectOnHarmonics(
          degree, 2 * degree,
          [&](const Vector3& u) { return Gradients(shape.EvaluateSecondOrder(u))(component); });
      this->Components.emplace_back(degree, coefficients);
    }
  }

  /// The largest |x'''| over the great circles through a parameter. As a function of their angle it
  /// is the length of a trigonometric polynomial of degree 3, to which the same inequality applies.
  double LargestAt(const CenteredSurface::SecondOrderSample& sample, const Vector3& u) const
  {
    constexpr int Angles = 12; // in half a turn, after which the derivatives repeat negatively
    std::array<RadialEvaluator::SecondOrderSample, 9> samples;
    std::transform(this->Components.begin(), this->Components.end(), samples.begin(),
                   [&](const auto& component) { return component.EvaluateSecondOrder(u); });
    double largest = 0.0;
    for (int i = 0; i < Angles; ++i)
    {
      const double angle = M_PI * i / Angles;
      const Vector3 t = std::cos(angle) * sample.Tangents[0] + std::sin(angle) * sample.Tangents[1];
      largest = std::max(largest, Along(t, samples).norm());
    }
    return largest / std::cos(3.0 * 0.5 * M_PI / Angles);
  }

private:
  // Row k: the surface gradient of coordinate k.
  static Matrix3 Gradients(const CenteredSurface::SecondOrderSample& sample)
  {
    return sample.First[0] * sample.Tangents[0].transpose() +
           sample.First[1] * sample.Tangents[1].transpose();
  }

  static Vector3 Along(const Vector3& t,
                       const std::array<RadialEvaluator::SecondOrderSample, 9>& samples)
  {
    Vector3 third = Vector3::Zero();
    for (std::size_t component = 0; component < samples.size(); ++component)
    {
      const auto& [value, slope, hessian] = samples[component];
      const auto coordinate = static_cast<Eigen::Index>(component % 3);
      const auto axis = static_cast<Eigen::Index>(component / 3);
      third[coordinate] += t[axis] * (t.dot(hessian * t) + value);
    }
    return third;
  }

  std::vector<RadialEvaluator> Components; // of matrices, column by column
};

// rad.
double LongestEdge(const IcosahedronDirections& sphere)
{
  double longest = 0.0;
  const auto& directions = sphere.Directions();
  for (const auto& [a, b, c] : sphere.Triangles())
  {
    const Vector3& first = directions[static_cast<std::size_t>(a)];
    const Vector3& second = directions[static_cast<std::size_t>(b)];
    const Vector3& third = directions[static_cast<std::size_t>(c)];
    longest = std::max({longest, (first - second).squaredNorm(), (second - third).squaredNorm(),
                        (third - first).squaredNorm()});
  }
  return 2.0 * std::asin(0.5 * std::sqrt(longest));
}
} // namespace

PointDerivativeBounds::PointDerivativeBounds(const CenteredSurface& shape) : Point{}
{
  constexpr int MostParts = 36;
  const ThirdDerivatives thirds(shape);
  const int degree = std::max(1, shape.Degree());
  const IcosahedronDirections sphere(std::max(degree, std::min(2 * degree, MostParts)));
  std::vector<double> largest;
  largest.reserve(sphere.Directions().size());
  for (const Vector3& parameter : sphere.Directions())
  {
    const auto sample = shape.EvaluateSecondOrder(parameter);
    this->Point[0] = std::max(this->Point[0], sample.Point.norm());
    this->Point[1] = std::max(this->Point[1], LargestFirst(sample));
    this->Point[2] = std::max(this->Point[2], LargestSecond(sample));
    largest.push_back(thirds.LargestAt(sample, parameter));
    this->Point[3] = std::max(this->Point[3], largest.back());
  }
  const double fall = std::cos(shape.Degree() * sphere.LargestGap());
  for (double& bound : this->Point)
  {
    bound /= fall;
  }
  // A symmetric form is largest with three equal arguments; the asymmetric part of the covariant
  // derivative is the curvature of the sphere, 1, times x'.
  this->PointThird = this->Point[3] + this->Point[1];

  const double edge = LongestEdge(sphere);
  this->Between = 0.25 * edge * edge * degree * degree * this->Point[3];
  // Fractions of the shortest wavelength.
  const CapMaxima::Angles angles{0.4 / degree, 1.0 / degree, 2.5 / degree};
  constexpr int MostCells = 48;
  this->Thirds =
      CapMaxima(sphere.Directions(), largest, angles, edge, std::min(3 * degree, MostCells));
}
} // namespace palpate
