#pragma once

#include "RandomShapes.h"
#include "SphericalHarmonicProjection.h"
#include "SurfaceModel.h"

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace palpate::test
{
/// Surface models that no radius describes: analytic maps of the unit sphere, projected on
/// harmonics. Lengths are mm, centres off the origin.
using SphereMap = std::function<Vector3(const Vector3&)>;

/// The surface of a given degree closest to a smooth map.
inline SurfaceModel ProjectMap(int degree, const SphereMap& map)
{
  const auto coordinate = [&](Eigen::Index axis)
  {
    return ProjectOnHarmonics(degree, 2 * degree + 40,
                              [&](const Vector3& u) { return map(u)[axis]; });
  };
  return {degree, {coordinate(0), coordinate(1), coordinate(2)}};
}

/// Exact at degree 1.
inline SurfaceModel EllipsoidPhantom(const Vector3& axes, int degree = 1)
{
  return ProjectMap(degree, [axes](const Vector3& u)
                    { return Vector3(Vector3(12.0, -7.0, 40.0) + axes.cwiseProduct(u)); });
}

/// A tube that is bent along `angle` (rad) of a circle of 20 mm, and thins out to its ends.
inline Vector3 BentTube(const Vector3& u, double angle, double thickness)
{
  constexpr double Bend = 20.0; // mm
  const double turn = 0.5 * angle * u[2];
  const Vector3 outward(std::cos(turn), std::sin(turn), 0.0);
  const double width = thickness * (1.0 + 0.4 * u[2] * u[2]);
  return Vector3(5.0, 60.0, -30.0) + (Bend + width * u[0]) * outward -
         width * u[1] * Vector3::UnitZ();
}

/// A C around 270 degrees, 14 mm thick.
inline SurfaceModel OpenRing(int degree = 16)
{
  return ProjectMap(degree, [](const Vector3& u) { return BentTube(u, 1.5 * M_PI, 7.0); });
}

/// The same around 370 degrees: its ends run into each other.
inline SurfaceModel CrossingRing(int degree = 16)
{
  return ProjectMap(degree,
                    [](const Vector3& u) { return BentTube(u, 370.0 / 180.0 * M_PI, 7.0); });
}

/// More than half of a spherical shell of 20 mm, 8 mm thick.
inline SurfaceModel Bowl(int degree = 16)
{
  return ProjectMap(degree,
                    [](const Vector3& u)
                    {
                      constexpr double Opening = 1.75; // rad, from the axis to the rim
                      const double side = std::hypot(u[0], u[1]);
                      const double angle = Opening * side;
                      const double radius = 20.0 + 4.0 * u[2];
                      const double across = side > 0.0 ? std::sin(angle) / side : Opening;
                      return Vector3(-25.0 + radius * across * u[0], radius * across * u[1],
                                     10.0 + radius * std::cos(angle));
                    });
}

/// A blob with a cleft that reaches half way through it.
inline SurfaceModel CleftBlob(int degree = 16)
{
  return ProjectMap(degree,
                    [](const Vector3& u)
                    {
                      const double depth = 12.0 * std::exp(-12.0 * u[0] * u[0] - 3.0 * u[1] * u[1]);
                      const Vector3 body(24.0 * u[0], 18.0 * u[1], 17.0 * u[2]);
                      return Vector3(body - Vector3(0.0, 0.0, u[2] > 0.0 ? u[2] * depth : 0.0));
                    });
}

/// A tube bent by 120 degrees with random bumps of every degree.
inline SurfaceModel BumpyTube(Random& random, int degree = 16)
{
  const SurfaceModel tube =
      ProjectMap(degree, [](const Vector3& u) { return BentTube(u, 2.0 / 3.0 * M_PI, 8.0); });
  std::array<std::vector<double>, 3> coefficients;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double>& sums = coefficients[static_cast<std::size_t>(axis)];
    sums = tube.Coefficients(axis);
    const std::vector<double> bumps = RandomCoefficients(random, degree, 1.5);
    for (std::size_t i = 1; i < sums.size(); ++i)
    {
      sums[i] += 1.2 * bumps[i];
    }
  }
  return {degree, coefficients};
}
} // namespace palpate::test
