#pragma once

#include "EvaluatorCases.h"
#include "SurfaceModel.h"

#include <array>
#include <vector>

namespace palpate::test
{
/// Three EvaluatorCases of one degree: white coefficients of each coordinate, and directions
/// everywhere, at and near both poles.
struct SurfaceCase
{
  explicit SurfaceCase(int degree) : Degree(degree), Axis{Case(degree), Case(degree), Case(degree)}
  {
    Random random(static_cast<unsigned>(600 + degree));
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Axis[k].Coefficients = RandomCoefficients(random, degree);
      this->Coefficients[k] = this->Axis[k].Coefficients;
    }
  }

  const std::vector<Vector3>& Directions() const { return this->Axis[0].Directions; }
  /// The promise of SurfaceEvaluator for this degree.
  double Bound() const { return this->Degree > 16 ? 1e-12 : 2e-14; }

  using Case = EvaluatorCase;
  int Degree;
  std::array<EvaluatorCase, 3> Axis;
  std::array<std::vector<double>, 3> Coefficients;
};

/// x(u) = axes * u.
inline SurfaceModel SurfaceModelEllipsoid(const Vector3& axes)
{
  const double scale = std::sqrt(4.0 * M_PI / 3.0);
  return {1,
          {std::vector<double>{0.0, 0.0, 0.0, scale * axes.x()},
           std::vector<double>{0.0, scale * axes.y(), 0.0, 0.0},
           std::vector<double>{0.0, 0.0, scale * axes.z(), 0.0}}};
}

/// A smooth body that is not star-shaped in general: an ellipsoid with random terms of all degrees,
/// off the origin.
inline SurfaceModel RandomSurface(Random& random, int degree)
{
  std::array<std::vector<double>, 3> coefficients;
  const Vector3 axes(40.0, 30.0, 20.0);
  std::uniform_real_distribution<double> offset(-200.0, 200.0);
  const SurfaceModel ellipsoid = SurfaceModelEllipsoid(axes).WithDegree(degree);
  for (std::size_t k = 0; k < 3; ++k)
  {
    coefficients[k] = RandomCoefficients(random, degree, 2.0);
    const std::vector<double>& axis = ellipsoid.Coefficients(static_cast<int>(k));
    for (std::size_t i = 0; i < axis.size(); ++i)
    {
      coefficients[k][i] = 10.0 * coefficients[k][i] + axis[i];
    }
    coefficients[k][0] += offset(random);
  }
  return {degree, coefficients};
}
} // namespace palpate::test
