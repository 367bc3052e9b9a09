#pragma once

#include "RegistrationStep.h"

#include <Eigen/Geometry>
#include <random>

namespace palpate::test
{
using Random = std::mt19937_64;

inline Vector3 RandomVector(Random& random, double deviation)
{
  std::normal_distribution<double> normal(0.0, deviation);
  const double x = normal(random);
  const double y = normal(random);
  return {x, y, normal(random)};
}

/// A shift and a turn of given sizes (mm, rad) in random directions, about the origin.
inline Eigen::Affine3d RandomMove(Random& random, double shift, double turn)
{
  const Vector3 axis = RandomVector(random, 1.0).normalized();
  const Vector3 way = RandomVector(random, 1.0).normalized();
  return Eigen::Translation3d(shift * way) * Eigen::Affine3d(Eigen::AngleAxisd(turn, axis));
}

/// Turn of a map (rad) and its shift at the origin (mm).
struct MapSize
{
  explicit MapSize(const Eigen::Affine3d& map)
      : Turn(Eigen::AngleAxisd(map.linear()).angle()), Shift(map.translation().norm())
  {
  }
  double Turn;
  double Shift;
};
} // namespace palpate::test
