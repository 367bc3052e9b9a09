#pragma once

#include "IcosahedronDirections.h"
#include "RadialModel.h"
#include "RandomShapes.h"
#include "Vector3.h"

#include <limits>
#include <vector>

namespace palpate::test
{
/// Slow reference for distances to a model's surface: the closest of 10^5 surface points, followed
/// by a descent that tries directions around the best one in ever smaller steps.
class NearestByBruteForce
{
public:
  explicit NearestByBruteForce(const RadialModel& model) : Model(model)
  {
    for (const Vector3& u : Directions())
    {
      this->Points.push_back(model.PointWorld(u));
    }
  }

  double Distance(const Vector3& queryWorld) const
  {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      const double square = (this->Points[i] - queryWorld).squaredNorm();
      if (square < least)
      {
        least = square;
        best = i;
      }
    }
    return this->Polish(queryWorld, Directions()[best], std::sqrt(least));
  }

  /// Frequency 100: 100,002 directions, 0.6 degrees apart.
  static const std::vector<Vector3>& Directions()
  {
    static const std::vector<Vector3> directions = IcosahedronDirections(100).Directions();
    return directions;
  }

private:
  double Polish(const Vector3& queryWorld, Vector3 u, double least) const
  {
    double step = 0.01; // rad
    for (int halving = 0; halving < 27; ++halving, step *= 0.5)
    {
      bool improves = true;
      while (improves)
      {
        improves = false;
        const Vector3 first = u.unitOrthogonal();
        const Vector3 second = u.cross(first);
        for (const double angle : {0.0, 0.8, 1.6, 2.4, 3.2, 4.0, 4.8, 5.6})
        {
          const Vector3 trial =
              (u + step * (std::cos(angle) * first + std::sin(angle) * second)).normalized();
          const double distance = (this->Model.PointWorld(trial) - queryWorld).norm();
          if (distance < least)
          {
            least = distance;
            u = trial;
            improves = true;
            break;
          }
        }
      }
    }
    return least;
  }

  RadialModel Model;
  std::vector<Vector3> Points;
};

/// A rough body: slowly decreasing power, and radii down to 30 % of the mean. `size` is the mean
/// radius in mm.
inline RadialModel RandomRough(Random& random, int degree, double size)
{
  std::vector<double> coefficients = RandomCoefficients(random, degree, 1.5);
  coefficients[0] = 0.0;
  const RadialModel relief(degree, coefficients, Vector3::Zero());
  double lowest = 0.0;
  const IcosahedronDirections sphere(20);
  for (const Vector3& u : sphere.Directions())
  {
    lowest = std::min(lowest, relief.Radius(u));
  }
  for (double& c : coefficients)
  {
    c *= 0.7 * size / -lowest;
  }
  coefficients[0] = size * std::sqrt(4.0 * M_PI);
  return {degree, coefficients, size * RandomDirection(random)};
}
} // namespace palpate::test
