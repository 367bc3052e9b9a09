#pragma once

#include "Vector3.h"

#include <random>

namespace palpate::test
{
/// A uniformly distributed random rotation.
inline Matrix3 RandomOrientation(std::mt19937_64& random)
{
  std::normal_distribution<double> normal;
  Eigen::Quaterniond quaternion;
  do
  {
    quaternion = {normal(random), normal(random), normal(random), normal(random)};
  } while (quaternion.norm() < 1e-3);
  return quaternion.normalized().toRotationMatrix();
}
} // namespace palpate::test
